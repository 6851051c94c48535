import { printAlone } from '#parts/print-alone.ts'

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
  const release = printAlone(sheet)
  const after = () => {
    release()
    sheet.remove()
  }
  window.addEventListener('afterprint', after, { once: true })
  window.print()
}
