import { mkdirSync, readFileSync, readdirSync, statfsSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { mount, testOnDisk } from '@botgarten/classroom/testing/small-disk'
import { openClassServer } from '@botgarten/server'
import { expect } from 'vitest'
import { botgarten } from './testing.ts'

testOnDisk('on a read-only disk each command ends with a sentence', 20, async (disk) => {
  const data = join(disk, 'data')
  mkdirSync(data)
  await (await openClassServer({ data })).close()
  const paper = join(disk, 'paper.txt')
  writeFileSync(paper, 'words')
  mount('-o', 'remount,ro', disk)
  const errorOf = async (...call: string[]) => {
    const { status, stderr } = await botgarten(...call, '--data', data)
    expect(status).toBe(1)
    return stderr
  }
  const nothing = `Nothing can be written into ${data} (EROFS)`
  expect(await errorOf('serve', '--port', '0')).toContain(nothing)
  expect(await errorOf('restore', join(data, 'botgarten.db'), '--phrase-file', paper)).toContain(nothing)
  for (const call of [['backup', join(tmpdir(), 'copy.age')], ['phrase'], ['teacher', 'reset', 'm.weber']])
    expect(await errorOf(...call)).toContain('The database cannot be opened')
  mount('-o', 'remount,rw', disk)
})

testOnDisk(
  'a backup and a restore that do not fit on a full disk say so, and change nothing',
  20,
  async (disk) => {
    const data = join(disk, 'data')
    await (await openClassServer({ data })).close()
    const file = join(disk, 'copy.age')
    const made = await botgarten('backup', file, '--data', data)
    const paper = join(disk, 'paper.txt')
    writeFileSync(paper, /(?:[a-z]+-){9}[a-z]+/.exec(made.stdout)![0])
    const before = readFileSync(join(data, 'botgarten.db'))
    const { bavail, bsize } = statfsSync(disk)
    writeFileSync(join(disk, 'ballast'), Buffer.alloc(bavail * bsize - 50_000))
    const full = await botgarten('backup', join(disk, 'second.age'), '--data', data)
    expect(full).toMatchObject({ status: 1 })
    expect(full.stderr).toContain('could not be written')
    const restored = await botgarten('restore', file, '--phrase-file', paper, '--data', data)
    expect(restored).toMatchObject({ status: 1 })
    expect(restored.stderr).toContain('could not be restored: ENOSPC')
    expect(readdirSync(disk).toSorted()).toEqual(['ballast', 'copy.age', 'data', 'paper.txt'])
    expect(readdirSync(join(data, 'backups'))).toEqual([])
    expect(readFileSync(join(data, 'botgarten.db')).equals(before)).toBe(true)
  },
)
