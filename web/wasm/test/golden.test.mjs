import { testPrograms } from "./programs.mjs";

testPrograms("tests/golden", 3);
