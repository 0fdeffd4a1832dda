async function instantiate(coming, imports) {
    const response = await coming;
    if (!response.ok) throw new Error(`${response.status} for ${response.url}`);
    // Only what is called wasm may be compiled while it comes.
    return response.headers.get("Content-Type") === "application/wasm"
        ? WebAssembly.instantiateStreaming(response, imports)
        : WebAssembly.instantiate(await response.arrayBuffer(), imports);
}
