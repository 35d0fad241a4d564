/** While what is above it still comes, something may stick out at the bottom. */
const WITHIN = { rootMargin: '0px 0px -15% 0px' }

/** Tells when an element comes into sight for the first time. */
export function sighted(node: Element, tell: () => void): { destroy(): void } {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return
    observer.disconnect()
    tell()
  }, WITHIN)
  observer.observe(node)
  return { destroy: () => observer.disconnect() }
}
