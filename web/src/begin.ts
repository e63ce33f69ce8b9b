// Begins while the browser still reads the page's script.

import { begin } from "./begun";

begin();
