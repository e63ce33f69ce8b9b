export {f: [x => x^2]} to "data.json"
