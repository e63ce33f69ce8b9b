import "lib" as folder
