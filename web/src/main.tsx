document.title = "tramline";
