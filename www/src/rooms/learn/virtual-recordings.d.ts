/** Made by plugins/recordings.ts: where each family's recording is. */
declare module 'virtual:recordings' {
  const addresses: Readonly<Record<import('../../catalogue/families').Family['name'], string>>
  export default addresses
}
