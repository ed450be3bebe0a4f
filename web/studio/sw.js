// Keeps Studio for use without a network: what the page fetched is kept, and the network is asked first, so that a new
// version comes at once. Only files of Studio itself; never a machine, never a server's answer with a token.
const KEPT = "yoke-studio-2";
const FILES = ["./", "studio.css", "studio.js", "plot.js", "film.js", "worker.js", "report.js", "core.wasm", "panels.wasm", "yoke.wasm", "gallery.json"];

self.addEventListener("install", (event) => {
  const keep = async () => {
    const cache = await caches.open(KEPT);
    await Promise.all(FILES.map((file) => cache.add(new Request(file, { cache: "reload" })).catch(() => undefined)));
    await self.skipWaiting();
  };
  event.waitUntil(keep());
});
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", (event) => {
  const address = new URL(event.request.url), isOurs = address.origin === self.location.origin;
  if (event.request.method !== "GET" || !isOurs || address.search || address.pathname.endsWith("/machine")) return;
  const answer = async () => {
    const cache = await caches.open(KEPT);
    try {
      const fresh = await fetch(event.request);
      if (fresh.ok) await cache.put(event.request, fresh.clone());
      return fresh;
    } catch {
      return (await cache.match(event.request, { ignoreVary: true })) ?? Response.error();
    }
  };
  event.respondWith(answer());
});
