/** What a browser remembers of the page, where it lets us. */
export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`forage.${key}`, value)
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}

export function recall(key: string): string | null {
  try {
    return localStorage.getItem(`forage.${key}`)
  } catch {
    return null
  }
}

export function forget(key: string): void {
  try {
    localStorage.removeItem(`forage.${key}`)
  } catch {
    // There is nothing then.
  }
}
