import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { readOperator } from './operator.ts'
import { CannotServe } from './problem.ts'

let folder = ''
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'botgarten-operator-'))))
afterEach(() => rmSync(folder, { recursive: true }))

function problemOf(read: () => unknown) {
  try {
    return read()
  } catch (error) {
    const { problem, facts } = error as CannotServe
    return { problem, facts }
  }
}

test('the usual file is read where no other is named', () => {
  const usual = join(folder, 'operator.md')
  expect(readOperator({}, usual)).toBeNull()
  writeFileSync(usual, '# Our school')
  expect(readOperator({}, usual)).toBe('# Our school')
})

test('a file that is named comes first, and is missed aloud', () => {
  const [usual, named] = [join(folder, 'operator.md'), join(folder, 'ours.md')]
  writeFileSync(usual, 'usual')
  expect(problemOf(() => readOperator({ BOTGARTEN_OPERATOR: named }, usual))).toEqual({
    problem: 'namedOperator',
    facts: { path: named, why: 'ENOENT' },
  })
  writeFileSync(named, 'named')
  expect(readOperator({ BOTGARTEN_OPERATOR: named }, usual)).toBe('named')
})

test('a folder in place of the file is a problem with a name, too', () => {
  expect(problemOf(() => readOperator({}, folder))).toMatchObject({ problem: 'usualOperator' })
  expect(problemOf(() => readOperator({ BOTGARTEN_OPERATOR: folder }, folder))).toMatchObject({
    facts: { why: 'EISDIR' },
  })
})
