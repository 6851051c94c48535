/** A cell that no spreadsheet takes for a formula, and that ends where it should. */
export function csvCell(value: string | number): string {
  const text = String(value)
  const tame = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text
  return /[",;\n\r]/.test(tame) ? `"${tame.replaceAll('"', '""')}"` : tame
}

/** A table as CSV, with the mark by which spreadsheets know UTF-8. In German cells are parted by semicolons. */
export function csv(rows: readonly (readonly (string | number)[])[], language: string): string {
  const mark = language === 'de' ? ';' : ','
  return `\uFEFF${rows.map((row) => row.map(csvCell).join(mark)).join('\r\n')}\r\n`
}
