import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { readPdf, type ReadPdf } from '../../e2e/pdf.ts'
import { inHouse } from '../../scripts/prepare/house.mjs'
import type { Finding } from './findings.ts'

/** Where codes lead on the pages that are looked at. */
export const address = 'https://botgarten.example.org'

/** Prints items by the command line, and reads the files in the order of the items. */
export async function printed(ids: readonly string[], language: string, paper: string): Promise<ReadPdf[]> {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-pages-'))
  try {
    const wishes = ['--lang', language, '--paper', paper, '--out', folder, '--address', address, '--json']
    const said = execFileSync(process.execPath, [
      inHouse('apps', 'cli', 'botgarten.ts'),
      'print',
      ...ids,
      ...wishes,
    ])
    const written = JSON.parse(said.toString()) as { file: string }[]
    return await Promise.all(written.map(({ file }) => readPdf(readFileSync(file))))
  } finally {
    rmSync(folder, { recursive: true })
  }
}

/** Fewer letters, lines and pictures than these are no page. */
const leastMarks = 12

/** Levels of headings that skip one. */
const jumps = (levels: readonly number[]) =>
  levels.filter((level, index) => level > (levels[index - 1] ?? 0) + 1).length

/** What is wrong with a file that is not seen on it. */
export function findingsIn(pdf: ReadPdf, language: string): readonly Finding[] {
  const { pages } = pdf
  const silent = pages.reduce((sum, page) => sum + page.silentFigures, 0)
  const skipped = jumps(pages.flatMap(({ headings }) => headings))
  const each = pages.flatMap(({ missingFonts, outside, marks }, index) => [
    ...missingFonts.map((font) => `page ${index + 1}: the font ${font} is not in it`),
    ...outside.map((text) => `page ${index + 1}: “${text}” stands beyond the edge`),
    ...(marks < leastMarks ? [`page ${index + 1}: ${marks} marks`] : []),
  ])
  return [
    ...(pdf.tagged ? [] : ['no tags']),
    ...(pdf.language?.startsWith(language) ? [] : [`language ${pdf.language}`]),
    ...(pdf.title.trim() ? [] : ['no title']),
    ...(pdf.outline.length > 0 ? [] : ['no outline']),
    ...(pages[0]?.headings[0] === 1 ? [] : ['no first heading']),
    ...(skipped > 0 ? [`${skipped} levels of headings are skipped`] : []),
    ...(silent > 0 ? [`${silent} figures without words`] : []),
    ...each,
  ].map((what) => ({ kind: 'file', what }))
}
