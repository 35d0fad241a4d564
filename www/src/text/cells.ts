/** What a cell begins with that spreadsheets carry out, and the mark itself, so that it can be taken away again: as the shell has it. */
const RISKY = /^[=+\-@\t\r']/
/** Spreadsheets show a cell behind it as text. */
const MARK = "'"

/** A text as a cell of a CSV file. Numbers stay numbers. */
export function cell(text: string): string {
  const safe = RISKY.test(text) && Number.isNaN(Number(text)) ? MARK + text : text
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe
}
