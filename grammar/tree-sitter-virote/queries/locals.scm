; Where names are known, where they are defined, and where they are used.

[
  (script)
  (test)
  (function)
  (lambda)
  (comprehension)
  (block)
] @local.scope

(param name: (identifier) @local.definition.parameter)
(function name: (identifier) @local.definition.function)
(parameter name: (identifier) @local.definition.parameter)
(lambda_parameters (identifier) @local.definition.parameter)
(definition pattern: (identifier) @local.definition.var)
(generator pattern: (identifier) @local.definition.var)
(list_pattern (identifier) @local.definition.var)
(record_pattern (identifier) @local.definition.var)
(import name: (identifier) @local.definition.import)

(identifier) @local.reference
