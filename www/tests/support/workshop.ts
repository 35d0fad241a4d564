import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { expect } from './lab'

/* The Workshop as somebody uses it. */

export const template = (name: string): string => readFileSync(new URL(`../../../templates/${name}.js`, import.meta.url), 'utf8')
export const CLIMBER = template('hill-climber')

/** The Workshop, with this code in its editor. */
export async function opened(page: Page, code: string): Promise<void> {
  await page.addInitScript((text) => {
    if (location.protocol === 'about:') return
    if (!sessionStorage.getItem('begun')) localStorage.setItem('forage.workshop.draft', JSON.stringify({ code: text, foreign: false }))
    sessionStorage.setItem('begun', 'yes')
  }, code)
  await page.goto('./#view=workshop')
  await page.getByTestId('editor').waitFor()
}

/** Puts the cursor behind a text. */
export async function behind(page: Page, text: string): Promise<void> {
  await page.getByTestId('editor').click()
  await page.keyboard.press('Control+f')
  await page.keyboard.type(text)
  await page.keyboard.press('Enter')
  await page.keyboard.press('Escape')
  await page.keyboard.press('ArrowRight')
}

export async function run(page: Page, said = 'The page runs this code'): Promise<void> {
  await page.getByTestId('run-code').click()
  await expect(page.getByTestId('state')).toContainText(said)
}
