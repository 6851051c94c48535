import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { readOperator } from './operator.ts'
import { Trouble } from './prepare/run.mjs'

let folder = ''
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'botgarten-operator-'))))
afterEach(() => rmSync(folder, { recursive: true }))

test('the usual file is read where no other is named', () => {
  const usual = join(folder, 'operator.md')
  expect(readOperator({}, usual)).toBeNull()
  writeFileSync(usual, '# Our school')
  expect(readOperator({}, usual)).toBe('# Our school')
})

test('a file that is named comes first, and is missed aloud', () => {
  const [usual, named] = [join(folder, 'operator.md'), join(folder, 'ours.md')]
  writeFileSync(usual, 'usual')
  expect(() => readOperator({ BOTGARTEN_OPERATOR: named }, usual)).toThrow(named)
  expect(() => readOperator({ BOTGARTEN_OPERATOR: named }, usual)).toThrow(Trouble)
  writeFileSync(named, 'named')
  expect(readOperator({ BOTGARTEN_OPERATOR: named }, usual)).toBe('named')
})

test('a folder in place of the file is a sentence too, without a stack', () => {
  expect(() => readOperator({}, folder)).toThrow(Trouble)
  expect(() => readOperator({ BOTGARTEN_OPERATOR: folder }, folder)).toThrow(
    /cannot be read \(EISDIR\).+leave/,
  )
})
