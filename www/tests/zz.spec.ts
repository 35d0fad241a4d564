import { linkTo } from './support/core'
import { test } from './support/lab'
test('zoom', async ({ lab, page }) => {
  await page.addInitScript(() => {
    const log: string[] = []; (window as any).log = log
    const P = CanvasRenderingContext2D.prototype as any
    let cur: string[] = []
    for (const m of ['fillRect','stroke','fill','moveTo','lineTo','arc','fillText','setTransform','drawImage','setLineDash']) { const o = P[m]; P[m] = function (...a: any[]) { if (m === 'fillRect' && a[0] === 0 && a[1] === 0 && a[2] > 500) { cur = []; (window as any).frames = [...((window as any).frames ?? []), cur] } cur.push(m + JSON.stringify(a) + (m === 'stroke' || m === 'fill' || m === 'fillText' ? [this.strokeStyle, this.fillStyle, this.lineWidth, this.globalAlpha, this.font, this.lineCap, this.lineJoin, this.filter, this.globalCompositeOperation].join() : '')); return o.apply(this, a) } }
  })
  await lab.open(linkTo({}, 30)); await lab.settled(30); await lab.stage.focus()
  const a = (await lab.picture()).digest
  const n = await page.evaluate(() => (window as any).frames.length)
  await page.keyboard.press('0'); const b = (await lab.picture()).digest
  console.log(a, b, n, await page.evaluate((n) => { const f = (window as any).frames; const x = f[n-1], y = f.at(-1); let i = 0; while (i < x.length && x[i] === y[i]) i++; return JSON.stringify([f.length, x.length, y.length, i, x.slice(i, i+3), y.slice(i, i+3)]) }, n))
})
