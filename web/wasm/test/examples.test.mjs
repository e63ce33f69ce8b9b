import { testPrograms } from "./programs.mjs";

testPrograms("examples");
