// The Markdown of the interpreter's own help as elements; texts reach the page as texts, and links are only named.

import { el } from "../../../src/panels/dom";

const INLINE = /`([^`]+)`|\*\*([^*]+)\*\*|\[([^\]]*)\]\([^)]*\)/g;

/** Elements of a text of Markdown: code, headings, lists, tables as they are written, paragraphs. */
export function markdown(text: string): HTMLElement {
  const root = el("div", { class: "help-text" });
  const lines = text.split("\n");
  for (let i = 0; i < lines.length; ) {
    const until = (isLast: (line: string) => boolean): string[] => {
      const begin = i;
      while (i < lines.length && !isLast(lines[i])) i++;
      return lines.slice(begin, i);
    };
    const line = lines[i];
    const heading = /^#{1,6} (.*)/.exec(line);
    if (line.startsWith("```")) {
      i++;
      root.append(el("pre", {}, until((one) => one.startsWith("```")).join("\n")));
      i++;
    } else if (heading) {
      root.append(el("h4", {}, ...inline(heading[1])));
      i++;
    } else if (line.startsWith("|")) {
      root.append(el("pre", {}, until((one) => !one.startsWith("|")).join("\n")));
    } else if (/^\s*[-*] /.test(line)) {
      const items = until((one) => !/^\s*[-*] /.test(one));
      root.append(el("ul", {}, ...items.map((item) => el("li", {}, ...inline(item.replace(/^\s*[-*] /, ""))))));
    } else if (line.trim() === "") {
      i++;
    } else {
      root.append(el("p", {}, ...inline(until((one) => one.trim() === "" || /^(```|\||#{1,6} |\s*[-*] )/.test(one)).join(" "))));
    }
  }
  return root;
}

function inline(text: string): (Node | string)[] {
  const made: (Node | string)[] = [];
  let end = 0;
  for (const found of text.matchAll(INLINE)) {
    made.push(text.slice(end, found.index));
    const [whole, code, strong, link] = found;
    made.push(code !== undefined ? el("code", {}, code) : strong !== undefined ? el("b", {}, strong) : link);
    end = found.index + whole.length;
  }
  made.push(text.slice(end));
  return made;
}
