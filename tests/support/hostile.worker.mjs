// The thread of hostile.html: what does not mean well runs here.
postMessage({ loaded: 'its modules' })
try {
  const [{ registerCode }, { ready, Session }, { attack }] = await Promise.all([
    import('../../pkg/isolate.js'),
    import('../../pkg/page.js'),
    import('../hostile.mjs'),
  ])
  postMessage({ loaded: 'the WebAssembly' })
  await ready(() => new Session({ planner: 'pso', scene: 'sphere-2' }).free())
  const found = await attack({ registerCode, Session, ontry: (trying) => postMessage({ trying: trying.slice(0, 300) }) })
  postMessage({ attacked: JSON.stringify(found) })
} catch (error) {
  // Not every engine reports what a module rejects with.
  postMessage({ attacked: JSON.stringify({ wrong: [String(error)], attacks: 0 }) })
}
