// Makes pages of the documentation, in which each script opens in the playground.
//   node book.mjs DOCS OUT MODULE
// DOCS is the folder of Markdown, OUT the folder of the playground, MODULE the compiled interpreter, which colours the scripts.

import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { deflateRawSync } from "node:zlib";
import { Marked } from "marked";
import { open } from "../wasm/virote.mjs";

const [docs, out, wasm] = process.argv.slice(2);
const book = join(out, "book");
/** The pages in their order, with what they are called in the bar. */
const PAGES = [
  ["language", "Language"],
  ["reference", "Reference"],
  ["numerics", "Numbers"],
  ["playground", "Playground"],
  ["view", "Viewer"],
  ["editors", "Editors"],
  ["studies", "Studies"],
];
const virote = await open(new WebAssembly.Module(readFileSync(wasm)), 1);
const escaped = (text) => text.replace(/[&<>"]/g, (letter) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[letter]);

/** A script with its words marked as the editor marks them. */
function coloured(text) {
  virote.ask({ call: "edit", text });
  const starts = [0];
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1);
  const offset = ({ line, column }) => starts[line] + column;
  let [made, end] = ["", 0];
  for (const { range, kind, isDeclaration, isBuiltIn } of virote.ask({ call: "tokens" }).value) {
    const [from, to] = [offset(range.from), offset(range.to)];
    const classes = `word-${kind}${isDeclaration ? " word-declared" : ""}${isBuiltIn ? " word-built-in" : ""}`;
    made += `${escaped(text.slice(end, from))}<span class="${classes}">${escaped(text.slice(from, to))}</span>`;
    end = to;
  }
  return made + escaped(text.slice(end));
}

/** The address of the playground with a script; link.ts reads it. */
function scriptLink(name, text) {
  const packed = deflateRawSync(JSON.stringify({ name, text }), { level: 9 }).toString("base64url");
  return `../#script=${packed}`;
}

/** The name of a heading in an address, as readers of the Markdown make it. */
const anchorOf = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}_ -]/gu, "").replaceAll(" ", "-");
const plain = (html) => html.replace(/<[^>]*>/g, "").replace(/&(amp|lt|gt|quot|#39);/g, (_, name) => ({ amp: "&", lt: "<", gt: ">", quot: '"', "#39": "'" })[name]);

/** Where a link of the Markdown leads; what is no page is copied beside them. */
function target(href) {
  if (/^(https?:|#)/.test(href)) return href;
  const [path, anchor] = href.split("#");
  const page = /^(\w+)\.md$/.exec(path)?.[1];
  if (PAGES.some(([name]) => name === page)) return `${page}.html${anchor === undefined ? "" : `#${anchor}`}`;
  const from = join(docs, path);
  if (!existsSync(from)) throw new Error(`${href} leads nowhere`);
  const inside = path.replaceAll("../", "");
  mkdirSync(dirname(join(book, inside)), { recursive: true });
  copyFileSync(from, join(book, inside));
  return inside;
}

/** What is known of each page, to see that links lead somewhere. */
const anchors = new Map();
const links = [];

function pageOf(name, title) {
  const headings = [];
  const known = new Set();
  anchors.set(`${name}.html`, known);
  let [chapter, n] = [name, 0];
  const renderer = {
    heading({ tokens, depth }) {
      const html = this.parser.parseInline(tokens);
      const anchor = anchorOf(plain(html));
      known.add(anchor);
      [chapter, n] = [depth > 2 ? anchor : name, 0];
      if (depth === 2) headings.push([anchor, html]);
      return `<h${depth} id="${escaped(anchor)}">${html}</h${depth}>\n`;
    },
    code({ text, lang }) {
      if (!/^geo(-error)?$/.test(lang ?? "")) return `<pre class="${lang === "text" ? "answer" : ""}">${escaped(text)}</pre>\n`;
      const script = `${text}\n`;
      const link = scriptLink(`${chapter}${++n > 1 ? `-${n}` : ""}.geo`, script);
      return `<div class="script${lang === "geo" ? "" : " mistake"}"><pre>${coloured(text)}</pre><a href="${link}">Open in the playground</a></div>\n`;
    },
    link({ href, tokens }) {
      const to = target(href);
      links.push([`${name}.html`, to]);
      return `<a href="${escaped(to)}">${this.parser.parseInline(tokens)}</a>`;
    },
    image({ href, text }) {
      return `<img src="${escaped(target(href))}" alt="${escaped(text)}" loading="lazy">`;
    },
  };
  const body = new Marked({ renderer }).parse(readFileSync(join(docs, `${name}.md`), "utf8"));
  const bar = PAGES.map(([one, text]) => `<a href="${one}.html"${one === name ? ' aria-current="page"' : ""}>${text}</a>`).join("\n");
  const contents = headings.map(([anchor, html]) => `<li><a href="#${escaped(anchor)}">${html}</a></li>`).join("\n");
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'self'; img-src 'self' data:">
<title>${title} · virote</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="../book.css">
</head>
<body>
<nav class="bar" aria-label="Pages"><a class="home" href="../">virote</a>${bar}</nav>
<main>
<nav class="contents" aria-label="Contents"><ul>${contents}</ul></nav>
<article>${body}</article>
</main>
</body>
</html>
`;
}

mkdirSync(book, { recursive: true });
for (const [name, title] of PAGES) writeFileSync(join(book, `${name}.html`), pageOf(name, title));
for (const [from, to] of links) {
  const [page, anchor] = to.startsWith("#") ? [from, to.slice(1)] : to.split("#");
  if (anchor !== undefined && anchors.has(page) && !anchors.get(page).has(anchor)) throw new Error(`${from}: ${to} leads nowhere`);
}
