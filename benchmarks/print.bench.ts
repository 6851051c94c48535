import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { readPdf } from '../e2e/pdf.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { inHouse } from '../scripts/prepare/house.mjs'
import type { Table } from './bench.ts'

interface Set {
  readonly seconds: number
  readonly files: number
  readonly pages: number
  readonly bytes: number
  /** Files that are not tagged, do not say their language or lack a font. */
  readonly poor: readonly string[]
}

/** Does something with a folder of its own, and throws the folder away whatever happens. */
async function inFolder<Made>(make: (folder: string) => Promise<Made>): Promise<Made> {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-print-'))
  try {
    return await make(folder)
  } finally {
    rmSync(folder, { recursive: true })
  }
}

async function printed(language: string, out: string): Promise<Set> {
  const began = performance.now()
  const call = ['print', 'all', '--lang', language, '--out', out]
  execFileSync(process.execPath, [
    inHouse('apps', 'cli', 'botgarten.ts'),
    ...call,
    '--address',
    'https://botgarten.example.org',
  ])
  const seconds = (performance.now() - began) / 1000
  const files = readdirSync(out)
  let [pages, bytes] = [0, 0]
  const poor: string[] = []
  for (const file of files) {
    const pdf = await readPdf(readFileSync(join(out, file)))
    pages += pdf.pages.length
    bytes += statSync(join(out, file)).size
    const complete = pdf.pages.every(({ missingFonts }) => missingFonts.length === 0)
    if (!pdf.tagged || !pdf.language?.startsWith(language) || !complete) poor.push(file)
  }
  return { seconds, files: files.length, pages, bytes, poor }
}

/** The whole set of materials as PDF. */
export default async function print(): Promise<Table> {
  await buildWhenNeeded()
  const rows: (string | number)[][] = []
  for (const language of ['de', 'en']) {
    const { seconds, files, pages, bytes, poor } = await inFolder((out) => printed(language, out))
    const size = `${(bytes / 1e6).toFixed(1)} MB`
    rows.push([language, files, pages, `${seconds.toFixed(1)} s`, size, poor.join(', ') || 'all'])
  }
  return {
    title: 'The whole set of materials as PDF',
    how: '`botgarten print all`, cards two on A4: the built lab is served and printed by the machine’s Chromium, one page after the other; from the call to the last file. Then every file is read back.',
    columns: ['language', 'files', 'pages', 'time', 'size', 'tagged, with language and fonts'],
    rows,
  }
}
