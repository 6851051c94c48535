import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { ofTeachers } from '../../words.ts'

const source = join(import.meta.dirname, '..')
const files = globSync('**/*.{ts,svelte}', { cwd: source }).filter((file) => !/\.test\.ts$/.test(file))

test('messages that no device stores for times without a network are named by pages of teachers alone', () => {
  const naming = files.filter((file) =>
    ofTeachers.some((name) =>
      new RegExp(`words: \\[[^\\]]*'${name}'|fetchWords\\([^)]*'${name}'|\\bm\\['${name}\\.`).test(
        readFileSync(join(source, file), 'utf8'),
      ),
    ),
  )
  expect(naming).toContain('features/teacher/feature.ts')
  expect(naming.filter((file) => !file.startsWith('features/teacher/'))).toEqual([])
})
