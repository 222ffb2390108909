// Unpacks the other scripts and runs them. They would be an eighth of a small page.
const opened = (async () => {
  const say = text => document.getElementById("message").textContent = text;
  if (typeof DecompressionStream === "undefined") {
    say("This browser is too old for this page: it cannot unpack gzip.");
    return null;
  }
  try {
    const packed = Uint8Array.from(atob(document.getElementById("player").textContent), letter => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const script = document.createElement("script");
    script.textContent = `"use strict";\n${await new Response(stream).text()}`;
    document.body.append(script);
  } catch (error) {
    say(`This page is damaged (${error.message}).`);
    throw error;
  }
  return open();
})();
