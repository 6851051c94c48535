import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, test } from 'vitest'

const root = join(import.meta.dirname, '..')
const files = globSync('**/*.svelte', { cwd: root })
  .toSorted()
  .map((path) => ({ path, text: readFileSync(join(root, path), 'utf8') }))
  .filter(({ path, text }) => path !== 'parts/Dialog.svelte' && /<Dialog[\s>]/.test(text))

/** A dialog that the user has to answer: it is closed by its own buttons alone. */
const answered = ['features/class/view/Gate.svelte', 'features/class/view/live/Attention.svelte']

describe.each(files.map(({ path, text }) => [path, text] as const))('the dialog in %s', (path, text) => {
  const tag = /<Dialog[\s\S]*?>\n/.exec(text)![0]

  test('has a name, and closes by Escape unless it has to be answered', () => {
    expect(tag).toMatch(/labelledby|label=|\{label\}/)
    expect(/onclose/.test(tag)).toBe(!answered.includes(path))
  })
})
