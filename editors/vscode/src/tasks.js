// Tasks as the arguments of the command.

"use strict";

/** The arguments of a task: the verb, then the script. */
exports.taskArguments = ({ verb, file }) => (file ? [verb, file] : [verb]);
