/* What passes where a browser asks for trusted types: scripts of the page's own threads, and formulas that were made while building. */

interface Rules {
  createHTML(html: string): string
  createScriptURL(address: string): string
}

interface Policies {
  createPolicy(name: string, rules: Rules): { [rule in keyof Rules]: (text: string) => unknown }
}

const policy = (globalThis as { trustedTypes?: Policies }).trustedTypes?.createPolicy('forage', {
  createHTML(html) {
    if (!html.startsWith('<math')) throw new TypeError('this is no formula')
    return html
  },
  createScriptURL(address) {
    const own = new URL(address, location.href)
    if (own.protocol !== 'blob:' && own.origin !== location.origin) throw new TypeError(`${address} is not of this page`)
    return address
  },
})

/** The address of a thread's script. */
export const scriptAddress = (address: string): string => (policy?.createScriptURL(address) ?? address) as string

/** A formula as MathML, to be put into the page. */
export const formula = (mathml: string): string => (policy?.createHTML(mathml) ?? mathml) as string
