import { readFile } from 'node:fs/promises'
import { checkScene } from '../../pkg/node.js'
import { linkTo, sceneOf } from './support/core'
import { en, expect, type Lab, test } from './support/lab'

async function exported(lab: Lab, id: string): Promise<{ name: string; content: Buffer }> {
  const started = lab.page.waitForEvent('download')
  await lab.page.getByTestId(`export-${id}`).click()
  const download = await started
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) }
}

test('scene, result, picture, drawing and curve are exported as they stand', async ({ lab, page }) => {
  await lab.open(linkTo({}, 40))
  const hash = await lab.settled(40)
  await lab.press(en.bar.exports)
  await expect(page.getByTestId('export-dialog')).toBeVisible()

  await test.step('scene', async () => {
    const { name, content } = await exported(lab, 'scene')
    expect(name).toBe('wcpso-discs.json')
    expect(checkScene(JSON.parse(content.toString()))).toEqual(sceneOf({}))
  })
  await test.step('result', async () => {
    const { content } = await exported(lab, 'result')
    expect(JSON.parse(content.toString())).toMatchObject({ planner: 'wcpso', seed: 1, iterations: 40, hash, feasible: true })
  })
  await test.step('picture', async () => {
    await lab.page.getByTestId('export-caption').uncheck()
    const { name, content } = await exported(lab, 'png')
    const { width, height } = await lab.picture()
    expect(name).toMatch(/\.png$/)
    expect(content.subarray(0, 8).toString('latin1')).toBe('\x89PNG\r\n\x1a\n')
    expect([content.readUInt32BE(16), content.readUInt32BE(20)]).toEqual([width, height])
  })
  await test.step('drawing', async () => {
    const { content } = await exported(lab, 'svg')
    const [root] = /<\w+/.exec(content.toString()) ?? []
    const drawn = { root, shapes: content.toString().match(/<(?:path|circle|polyline|line)\b/g)?.length }
    expect(drawn.root).toBe('<svg')
    expect(drawn.shapes).toBeGreaterThan(8)
  })
  await test.step('curve', async () => {
    const { content } = await exported(lab, 'csv')
    const [head = '', ...rows] = content.toString().trim().split('\n')
    expect(head.split(',')).toEqual(expect.arrayContaining(['iteration', 'best', 'mean']))
    expect(rows).toHaveLength(41)
    expect(rows.at(-1)).toMatch(/^40,/)
  })
})

test('the exported drawing has the layers that are on, and no others', async ({ lab }) => {
  await lab.open(linkTo({}, 40))
  await lab.settled(40)
  await lab.press(en.bar.exports)
  expect((await exported(lab, 'svg')).content.toString()).toContain('<g class="particles">')
  await lab.page.keyboard.press('Escape')
  await lab.layer('particles', false)
  await lab.press(en.bar.exports)
  const rest = (await exported(lab, 'svg')).content.toString()
  expect(rest).not.toContain('<g class="particles">')
  expect(rest).toContain('<g class="best">')
})
