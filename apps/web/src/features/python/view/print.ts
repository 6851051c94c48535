/** Prints a file with its line numbers and nothing else of the page. */
export function printCode(name: string, text: string): void {
  const sheet = document.createElement('pre')
  sheet.className = 'code-sheet'
  const rows = text.trimEnd().split('\n')
  const width = String(rows.length).length
  sheet.textContent = [name, '', ...rows.map((row, k) => `${String(k + 1).padStart(width)}  ${row}`)].join(
    '\n',
  )
  document.body.append(sheet)
  window.addEventListener('afterprint', () => sheet.remove(), { once: true })
  window.print()
}
