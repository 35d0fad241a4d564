// What a folder that is handed out contains of others, as CycloneDX has it: `sbom.cdx.json`, from its notices and the lock files. The
// same contents give the same bytes.
//   node package/sbom.mjs FOLDER NAME
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import { readFileSync, writeFileSync } from 'node:fs'

const root = new URL('..', import.meta.url)
const required = createRequire(new URL('www/package.json', root))
const { Enums, Models, Serialize, Spec, Validation } = required('@cyclonedx/cyclonedx-library')

const read = (path) => readFileSync(new URL(path, root), 'utf8')

/** The crates that the lock file knows, with their licences and what their archives hash to. */
function crates() {
  const metadata = execFileSync('cargo', ['metadata', '--locked', '--filter-platform', 'wasm32-unknown-unknown', '--format-version', '1'], {
    cwd: root,
    maxBuffer: 1 << 28,
    encoding: 'utf8',
  })
  const sums = new Map(
    [...read('Cargo.lock').matchAll(/^name = "(.*)"\nversion = "(.*)"\nsource = .*\nchecksum = "(.*)"$/gm)].map(
      ([, name, version, sum]) => [`${name} ${version}`, sum],
    ),
  )
  return new Map(
    JSON.parse(metadata).packages.map(({ name, version, license, description }) => [
      `${name} ${version}`,
      { name, version, license, description, purl: `pkg:cargo/${name}@${version}`, hash: ['SHA-256', sums.get(`${name} ${version}`)] },
    ]),
  )
}

/** The same of the packages. */
function packages() {
  const { packages } = JSON.parse(read('www/package-lock.json'))
  return new Map(
    Object.entries(packages).flatMap(([path, { version, license, integrity = '' }]) => {
      const name = path.split('node_modules/').at(-1)
      if (!path || !version) return []
      const [, sum = ''] = /^sha512-(.*)$/.exec(integrity) ?? []
      const purl = `pkg:npm/${name.replace('@', '%40')}@${version}`
      return [[`${name} ${version}`, { name, version, license, purl, hash: ['SHA-512', Buffer.from(sum, 'base64').toString('hex')] }]]
    }),
  )
}

/** What the notices of a folder list: `- crate 1.2.3` in the part of the wasm, `## package - 1.2.3 (MIT)` in the others. */
export function listed(notices) {
  const found = [...notices.matchAll(/^- (\S+) (\d\S*)$|^## (\S+) - (\d\S*) \(.*\)$/gm)]
  return found.map(([, crate, of, name = crate, version = of]) => ({ name, version, sort: crate ? 'cargo' : 'npm' }))
}

function component({ name, version, license, description, purl, hash: [algorithm, sum] }) {
  const licenses = new Models.LicenseRepository()
  // "MIT/Apache-2.0", as some old crates have it, is no expression.
  if (license) licenses.add(new Models.LicenseExpression(license.replace(/ ?\/ ?/g, ' OR ')))
  const hashes = new Models.HashDictionary(sum ? [[algorithm, sum]] : [])
  return new Models.Component(Enums.ComponentType.Library, name, {
    ...{ version, licenses, purl, hashes, bomRef: purl, description: description?.trim() },
    scope: Enums.ComponentScope.Required,
  })
}

export async function sbom(folder, title) {
  const known = { cargo: crates(), npm: packages() }
  const components = new Models.ComponentRepository()
  const seen = new Set()
  for (const { name, version, sort } of listed(readFileSync(`${folder}/THIRD-PARTY.md`, 'utf8'))) {
    // The package's own notices have packages in the list of crates, too.
    const found = known[sort].get(`${name} ${version}`) ?? known.npm.get(`${name} ${version}`)
    if (!found) throw new Error(`${name} ${version} is in the notices, and in no lock file`)
    if (!seen.has(found.purl)) components.add(component(found))
    seen.add(found.purl)
  }
  const [, version] = /^\[workspace\.package\]\nversion = "(.*)"$/m.exec(read('Cargo.toml'))
  const whole = new Models.Component(Enums.ComponentType.Application, title, { version, bomRef: title })
  whole.licenses.add(new Models.LicenseExpression('MIT OR Apache-2.0'))
  const bom = new Models.Bom({ components, metadata: new Models.Metadata({ component: whole }) })
  const spec = Spec.Spec1dot6
  const text = new Serialize.JsonSerializer(new Serialize.JSON.Normalize.Factory(spec)).serialize(bom, { sortLists: true, space: 2 })
  const wrong = await new Validation.JsonStrictValidator(spec.version).validate(text)
  if (wrong !== null) throw new Error(`no CycloneDX: ${JSON.stringify(wrong)}`)
  writeFileSync(`${folder}/sbom.cdx.json`, `${text}\n`)
  return components.size
}

const [folder, title] = process.argv.slice(2)
if (folder) console.info(`${folder}/sbom.cdx.json: ${await sbom(folder, title)} components`)
