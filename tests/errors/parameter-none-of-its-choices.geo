// --set finish=glos
param finish = "gloss" in ["gloss", "matt"]
