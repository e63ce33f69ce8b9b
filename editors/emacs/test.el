;;; test.el --- The language server in Emacs, by eglot, with what docs/editors.md says -*- lexical-binding: t -*-

;; emacs -q --batch -l test.el, with VIROTE for the command to test. Without eglot it tells so.

(require 'package)
(package-initialize)
(unless (require 'eglot nil t)
  (message "NOT CHECKED: Emacs has no eglot")
  (kill-emacs 0))
(require 'flymake)
(setq eglot-sync-connect 60 eglot-connect-timeout 60)

(defun virote-test-documented ()
  "Evaluates the Lisp of docs/editors.md."
  (with-temp-buffer
    (insert-file-contents (expand-file-name "../../docs/editors.md" (file-name-directory load-file-name)))
    (search-forward "```elisp\n")
    (let ((start (point)))
      (search-forward "```")
      (eval-region start (line-beginning-position)))))

(defun virote-test-until (what holds)
  "Waits until HOLDS, which says WHAT."
  (let ((turns 600))
    (while (and (< 0 turns) (not (funcall holds)))
      (accept-process-output nil 0.1)
      (setq turns (1- turns)))
    (unless (funcall holds) (error "%s: %S" what (buffer-string)))
    (message "ok: %s" what)))

(defun virote-test-face (text)
  "The face of the first TEXT of the buffer."
  (goto-char (point-min))
  (search-forward text)
  (get-text-property (match-beginning 0) 'face))

(defun virote-test-keywords ()
  "The words that the grammar for editors colours as keywords."
  (with-temp-buffer
    (insert-file-contents (expand-file-name "../../grammar/tree-sitter-virote/queries/highlights.scm" (file-name-directory load-file-name)))
    (let ((words nil))
      (while (re-search-forward "\\(?:\\[[^]]*\\]\\|\"[a-z]+\"\\) @keyword" nil t)
        (let ((group (match-string 0)) (start 0))
          (while (string-match "\"\\([a-z]+\\)\"" group start)
            (push (match-string 1 group) words)
            (setq start (match-end 0)))))
      words)))

(defun virote-test-colours ()
  "What is coloured, and as what."
  (with-temp-buffer
    (insert "/// How wide.\nlet total = 3mm // wide\ncurve keel: curve = f(\"let a\")\nfn twice(x) = 2 * x\nprint true\n/* let */\n")
    (virote-mode)
    (font-lock-ensure)
    (pcase-dolist (`(,text ,face)
                   '(("/// How" font-lock-comment-delimiter-face) ("How wide" font-lock-comment-face) ("let total" font-lock-keyword-face)
                     ("total" font-lock-variable-name-face) ("3mm" nil) ("curve keel" font-lock-type-face)
                     ("keel" font-lock-variable-name-face) ("\"let a" font-lock-string-face) ("let a" font-lock-string-face)
                     ("twice" font-lock-function-name-face) ("true" font-lock-constant-face) ("let */" font-lock-comment-face)))
      (unless (eq (virote-test-face text) face) (error "`%s' has %s, not %s" text (virote-test-face text) face)))
    (let ((words (virote-test-keywords)))
      (unless (< 20 (length words)) (error "the grammar has few words: %s" words))
      (dolist (word words)
        (erase-buffer)
        (insert "x " word " y\n")
        (font-lock-ensure)
        (unless (eq (virote-test-face word) 'font-lock-keyword-face) (error "`%s' is no keyword here" word)))))
  (message "ok: words, names, texts and comments have their colours"))

(virote-test-documented)
(virote-test-colours)
(setf (alist-get 'virote-mode eglot-server-programs) (list (getenv "VIROTE") "lsp"))
(let* ((folder (make-temp-file "virote-" t))
       (file (expand-file-name "hull.geo" folder)))
  (with-temp-file file
    (insert "/// How wide.\nlet total = 3mm\ncurve keel = line((0, 0), (total, 1mm))\nprint   totl\n"))
  (find-file file)
  (unless (eq major-mode 'virote-mode) (error "the mode is %s" major-mode))
  ;; In a batch there is no idle moment in which the hook connects.
  (unless (eglot-managed-p) (apply #'eglot--connect (eglot--guess-contact)))
  (virote-test-until "a finding is told with its hint"
    (lambda ()
      (flymake-start)
      (seq-some (lambda (found) (string-match-p "did you mean `total`" (flymake-diagnostic-text found)))
                (flymake-diagnostics))))
  (goto-char (point-min))
  (search-forward "total")
  (backward-char 2)
  (let ((told (plist-get (plist-get (jsonrpc-request (eglot--current-server-or-lose) :textDocument/hover
                                                     (eglot--TextDocumentPositionParams))
                                    :contents)
                         :value)))
    (unless (and (string-match-p "let total" told) (string-match-p "3 mm" told)) (error "hover: %s" told))
    (when (string-match-p "```" told) (error "plain text has fences: %s" told)))
  (message "ok: a hover tells kind and value")
  (eglot-format-buffer)
  (virote-test-until "the text is brought into its usual form"
    (lambda () (string-match-p "^print totl$" (buffer-string))))
  (goto-char (point-max))
  (insert "print tot")
  (virote-test-until "completion offers a name"
    (lambda () (member "total" (all-completions "tot" (nth 2 (eglot-completion-at-point))))))
  (goto-char (point-min))
  (search-forward "let tot")
  (eglot-rename "width")
  (virote-test-until "a name is replaced wherever it is used"
    (lambda () (string-match-p "let width = 3mm\ncurve keel = line((0, 0), (width, 1mm))" (buffer-string))))
  (set-buffer-modified-p nil)
  (delete-directory folder t))
;;; test.el ends here
