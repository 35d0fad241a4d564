import type { Catalogue } from 'forage-lab'
import address from 'forage-lab/catalogue.json?url'

/** What there is to choose from: known before any of the core is loaded. */
export async function readCatalogue(): Promise<Catalogue> {
  const found = await fetch(address)
  if (!found.ok) throw new Error(`${found.status} ${found.statusText}: ${address}`)
  return found.json()
}
