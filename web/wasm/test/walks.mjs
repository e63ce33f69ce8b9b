// Scripts that nest as deep as they are told, each in another way: the stack of whoever reads them is what ends.

const repeated = (text, n) => text.repeat(n);
export const WALKS = {
  brackets: (n) => `let a = ${repeated("(", n)}1${repeated(")", n)}`,
  signs: (n) => `let a = ${repeated("-", n)}1`,
  chain: (n) => `let a = 1${repeated(" + 1", n)}`,
  powers: (n) => `let a = 1${repeated("^1", n)}`,
  calls: (n) => `fn f(n) = if n <= 0 then 0 else 1 + f(n - 1)\nlet a = f(${n})`,
  "calls with blocks": (n) => `fn f(n) = { let b = [n, n + 1]\n if n <= 0 then 0 else sum([1, f(b[0] - 1)]) }\nlet a = f(${n})`,
  "calls inside comprehensions": (n) => `fn f(n) = if n <= 0 then [0] else [for i in 0..<1: f(n - 1)]\nlet a = f(${n})\nprint a == a`,
  "calls inside arguments": (n) => `fn f(n) = if n <= 0 then 0 else max(0, min(1000, abs(1 + (2 * f(n - 1) + 1) - 1)))\nlet a = f(${n})`,
  "calls by built-in functions": (n) => `fn f(n) = if n <= 0 then 0 else map([n - 1], f)[0] + 1\nlet a = f(${n})`,
  "calls of one another": (n) => `fn f(n) = if n <= 0 then true else g(n - 1)\nfn g(n) = if n <= 0 then false else f(n - 1)\nlet a = f(${n})`,
  lists: (n) => `let a = ${repeated("[", n)}1${repeated("]", n)}\nprint a`,
};
