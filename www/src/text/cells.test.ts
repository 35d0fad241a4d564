import { expect, test } from 'vitest'
import { cell } from './cells'

test('formulas are texts in a spreadsheet, and numbers stay numbers', () => {
  for (const [text, written] of [
    ['=1+1', "'=1+1"],
    ['+cmd', "'+cmd"],
    ['-2+3', "'-2+3"],
    ['@SUM(A1)', "'@SUM(A1)"],
    ["'quoted", "''quoted"],
    ['=HYPERLINK("http://a,b")', '"\'=HYPERLINK(""http://a,b"")"'],
    ['-1.5', '-1.5'],
    ['-1e-9', '-1e-9'],
    ['plain', 'plain'],
    ['', ''],
  ] as const)
    expect(cell(text)).toBe(written)
})
