-- Neovim, headless, with `virote lsp`: what its buffers show. Run by test.sh, which names the command.

-- Its settings are those of docs/editors.md, with the command found on the path.

local command = assert(os.getenv("VIROTE"), "VIROTE names the command")
assert(vim.fn.fnamemodify(command, ":t") == "virote", "the command is called virote")
vim.env.PATH = vim.fn.fnamemodify(command, ":p:h") .. ":" .. vim.env.PATH

local function documented()
  local here = vim.fn.fnamemodify(debug.getinfo(1, "S").source:sub(2), ":p:h")
  local page = table.concat(vim.fn.readfile(here .. "/../../docs/editors.md"), "\n")
  return assert(page:match("\n## Neovim\n.-\n```lua\n(.-)\n```"), "the page has lines for Neovim")
end

local function wait_for(what, condition)
  assert(vim.wait(60000, condition, 20), "waited in vain for " .. what)
end

local function same(what, found, expected)
  assert(vim.deep_equal(found, expected), what .. ": " .. vim.inspect(found) .. " instead of " .. vim.inspect(expected))
end

local function test()
  local folder = vim.fn.tempname()
  vim.fn.mkdir(folder)
  local path = folder .. "/main.geo"
  vim.fn.writefile({ "/// How wide. 🫖", "let   width = 27.2mm", "print /* 🫖 */ widht" }, path)
  assert(loadstring(documented()))()
  vim.cmd("edit " .. path)
  local buffer = vim.api.nvim_get_current_buf()
  same("the language", vim.bo.filetype, "virote")
  same("how comments begin", vim.bo.commentstring, "// %s")
  local function clients()
    local get = vim.lsp.get_clients or vim.lsp.get_active_clients
    return vim.tbl_filter(function(client) return client.name == "virote" end, get())
  end
  wait_for("the server", function() return #clients() == 1 end)
  local id = clients()[1].id

  local function findings()
    return vim.diagnostic.get(buffer)
  end
  wait_for("a finding", function() return #findings() == 1 end)
  local found = findings()[1]
  -- Neovim counts bytes.
  same("the place", { found.lnum, found.col, found.end_col }, { 2, 17, 22 })
  same("the code", found.code or found.user_data.lsp.code, "E0201")

  local function ask(method, more)
    local params = vim.tbl_extend("force", vim.lsp.util.make_position_params(), more or {})
    local answers = assert(vim.lsp.buf_request_sync(buffer, method, params, 60000))
    return answers[id].result
  end

  -- An edit mends it.
  vim.api.nvim_buf_set_text(buffer, 2, 17, 2, 22, { "width" })
  wait_for("no finding", function() return #findings() == 0 end)

  vim.api.nvim_win_set_cursor(0, { 3, 19 })
  local hover = ask("textDocument/hover")
  assert(hover.contents.value:find("27.2 mm", 1, true), hover.contents.value)
  local items = ask("textDocument/completion").items
  local labels = {}
  for _, item in ipairs(items) do labels[item.label] = item end
  same("the value in a completion", labels.width.detail, "27.2 mm")

  vim.lsp.buf.rename("größe")
  wait_for("the new name", function()
    return vim.api.nvim_buf_get_lines(buffer, 2, 3, false)[1] == "print /* 🫖 */ größe"
  end)
  -- The name of it since 0.8.
  if vim.lsp.buf.format then vim.lsp.buf.format({ timeout_ms = 60000 }) else vim.lsp.buf.formatting_sync(nil, 60000) end
  same("the text in canonical form", vim.api.nvim_buf_get_lines(buffer, 0, -1, false),
    { "/// How wide. 🫖", "let größe = 27.2mm", "print /* 🫖 */ größe" })
  wait_for("no finding of the new text", function() return #findings() == 0 end)
  vim.fn.delete(folder, "rf")
end

local is_well, why = xpcall(test, debug.traceback)
if is_well then
  print("neovim: findings, hover, completion, rename, formatting\n")
  vim.cmd("qall!")
else
  io.stderr:write(why .. "\n")
  vim.cmd("cquit 1")
end
