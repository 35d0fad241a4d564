import { expect, it } from 'vitest'
import { brief, briefPercent } from './brief'

it('numbers in prose end with their last digit', () => {
  expect([4.5, 0.03, 2.5, 12, 1 / 3, 0, -22.5, 37.5, 562.8427].map(brief)).toEqual([
    '4.5',
    '0.03',
    '2.5',
    '12',
    '0.3333',
    '0',
    '−22.5',
    '37.5',
    '562.8',
  ])
  expect([0, 1, 0.125, 1 / 3, 0.0005].map(briefPercent)).toEqual(['0 %', '100 %', '12.5 %', '33.33 %', '0.05 %'])
})
