import { writeProjectFile, type Project } from '@botgarten/programs/project'
import { rawText } from './raw.ts'

const types = { json: 'application/json', xml: 'application/xml', csv: 'text/csv', zip: 'application/zip' }
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
