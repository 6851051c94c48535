import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'

const root = join(import.meta.dirname, '..', '..')
const list = readFileSync(join(root, 'docs', 'class-rules.md'), 'utf8')
/** A rule, and below it the tests that hold it: a file and the beginning of a title. */
const rules = list.split(/^- /m).slice(1)
const named = [...list.matchAll(/^ {2}- `([^`]+)`: (.+)$/gm)]

test('every rule of a class names a test', () => {
  for (const rule of rules) expect(rule).toMatch(/\n {2}- `[\w./-]+\.(test|spec)\.ts`: /)
  expect(rules.length).toBeGreaterThan(40)
})

test.each(named.map(([, file, title]) => [file!, title!] as const))('%s holds "%s"', (file, title) => {
  // A short answer where it does not: not the whole file.
  expect(readFileSync(join(root, file), 'utf8').includes(title), `no test "${title}" in ${file}`).toBe(true)
})
