import { mkdirSync, mkdtempSync, rmSync, utimesSync, writeFileSync } from 'node:fs'
import { createHash } from 'node:crypto'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { needsInstall } from './install.mjs'

let folder = ''
const put = (name: string, text: string, seconds: number) => {
  writeFileSync(join(folder, name), text)
  utimesSync(join(folder, name), seconds, seconds)
}

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'botgarten-install-'))
  mkdirSync(join(folder, 'node_modules'))
  put('package-lock.json', 'two', 2000)
})
afterEach(() => rmSync(folder, { recursive: true }))

test('a clone without node_modules is installed', () => {
  rmSync(join(folder, 'node_modules'), { recursive: true })
  expect(needsInstall(folder)).toBe(true)
})

test('an install that broke off is done again', () => {
  expect(needsInstall(folder)).toBe(true)
})

test('an install older than the lock file is done again', () => {
  put('node_modules/.package-lock.json', '', 1000)
  expect(needsInstall(folder)).toBe(true)
})

test('an install younger than the lock file stays', () => {
  put('node_modules/.package-lock.json', '', 3000)
  expect(needsInstall(folder)).toBe(false)
})

test('a lock file that was only touched asks for no install', () => {
  put('node_modules/.package-lock.json', '', 1000)
  put('node_modules/.botgarten-lock', createHash('sha256').update('two').digest('hex'), 1000)
  expect(needsInstall(folder)).toBe(false)
  put('package-lock.json', 'three', 2000)
  expect(needsInstall(folder)).toBe(true)
})
