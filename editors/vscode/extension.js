// Starts `loadpath lsp` for the project files that are open.
const { workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

exports.activate = async () => {
  const settings = workspace.getConfiguration("loadpath");
  const selector = [{ language: "loadpath" }];
  const pattern = settings.get("pattern");
  if (pattern) selector.push({ language: "toml", pattern });
  const server = { command: settings.get("command"), args: ["lsp"] };
  client = new LanguageClient("loadpath", "loadpath", server, { documentSelector: selector });
  await client.start();
};

exports.deactivate = () => client?.stop();
