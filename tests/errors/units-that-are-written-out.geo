unit inches
