// Prints the examples of a folder for the page: their names and titles, and them and their data in base64.
//   node examples.mjs FOLDER

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const folder = process.argv[2];
const titles = new Map(
  [...readFileSync(join(folder, "README.md"), "utf8").matchAll(/\[`([\w-]+\.geo)`\]\([^)]*\): ([^|\n]*)/g)].map(([, name, title]) => [name, title.trim()]),
);
const names = readdirSync(folder, { withFileTypes: true })
  .filter((entry) => entry.isFile() && !/\.(md|rs|sh)$/.test(entry.name))
  .map((entry) => entry.name)
  .sort();
const firstComment = (name) => /^\/\/\s*(.*)/.exec(readFileSync(join(folder, name), "utf8"))?.[1] ?? "";
const scripts = names.filter((name) => name.endsWith(".geo"));
// In the order of the README, which goes from what is simple.
const order = [...titles.keys()];
const rank = (name) => (order.includes(name) ? order.indexOf(name) : order.length);
const examples = scripts.sort((a, b) => rank(a) - rank(b)).map((name) => ({ name, title: titles.get(name) ?? firstComment(name) }));
const files = Object.fromEntries(names.map((name) => [name, readFileSync(join(folder, name)).toString("base64")]));
console.log(JSON.stringify({ examples, files }));
