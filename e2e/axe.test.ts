// Contract of the walk with axe: no other test runs axe, so that no state is checked twice.
import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'

/** Other files that run axe, each with the reason why the walk cannot reach their states. */
const elsewhere: { readonly [file: string]: string } = {
  'tests/plain-http.spec.ts':
    'needs a browser that resolves a made-up name, which is a secure place under localhost',
}

const files = globSync('{*,tests/*,gate/*,walk/*}.ts', { cwd: import.meta.dirname }).map((file) =>
  file.replaceAll('\\', '/'),
)
const isWalk = (file: string) => /^tests\/axe(-\w+)?\.(spec|touch)\.ts$/.test(file)
const asks = (file: string) =>
  /from '\.{1,2}\/axe\.ts'/.test(readFileSync(join(import.meta.dirname, file), 'utf8'))

test('only the walk with axe asks axe, and what is listed with a reason', () => {
  expect(files.filter((file) => asks(file) && !isWalk(file))).toEqual(Object.keys(elsewhere))
  expect(files.filter(isWalk).every(asks)).toBe(true)
})
