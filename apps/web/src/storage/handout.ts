import { writeProjectFile, type Project } from '@botgarten/programs/project'

const types = {
  json: 'application/json',
  jsonl: 'application/jsonl',
  xml: 'application/xml',
  csv: 'text/csv',
  zip: 'application/zip',
  py: 'text/x-python',
  ipynb: 'application/x-ipynb+json',
  svg: 'image/svg+xml',
}
type Ending = 'botgarten.json' | 'brain.json' | keyof typeof types

const nameOfFile = (name: string) => name.replace(/[^\p{L}\p{N} _-]/gu, '').slice(0, 80) || 'botgarten'

/** Hands the project out as a file, through the browser's own download. */
export const saveProjectFile = (project: Project): void => handOut(project.name, writeProjectFile(project))

/** Hands out what lies in a record that cannot be read, as it lies there. */
export const saveRaw = (name: string, raw: unknown): void => handOut(name, rawText(raw), 'json')

export function handOut(
  name: string,
  content: string | Uint8Array<ArrayBuffer>,
  ending: Ending = 'botgarten.json',
): void {
  const type = types[ending.split('.').at(-1) as keyof typeof types]
  const address = URL.createObjectURL(new Blob([content], { type }))
  const link = document.createElement('a')
  link.href = address
  link.download = `${nameOfFile(name)}.${ending}`
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), 1000)
}

/** A file that holds a program, by its name: the page opens it wherever it is let go. */
export const isProgramFile = (name: string): boolean => /\.(xml|botgarten|botgarten\.json)$/i.test(name)

/** Is this a file of Open Roberta, by its name or by how it begins? */
export const isOpenRoberta = (name: string, text: string): boolean =>
  /\.xml$/i.test(name) || /^\uFEFF?\s*(<\?xml[^>]*>\s*)?<(\w+:)?export[\s>]/.test(text.slice(0, 1000))

/** Deeper than any project, and not so deep that writing it runs out of stack. */
const deepest = 500

/** Whatever lies in a record, as text for a file. What text cannot hold is named. */
export function rawText(value: unknown): string {
  try {
    const text = JSON.stringify(value) as string | undefined
    if (text !== undefined) return text
  } catch {
    // A circle, a number without end, or deeper than JSON can write.
  }
  return JSON.stringify(plain(value, 0, new Set())) ?? 'null'
}

function plain(value: unknown, depth: number, above: ReadonlySet<unknown>): unknown {
  if (typeof value === 'bigint' || typeof value === 'symbol') return String(value)
  if (typeof value !== 'object' || value === null) return value
  if (depth > deepest || above.has(value)) return '…'
  const inside = new Set(above).add(value)
  if (Array.isArray(value)) return value.map((one) => plain(one, depth + 1, inside))
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, plain(one, depth + 1, inside)]))
}
