import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { botgarten } from '../testing.ts'

const out = mkdtempSync(join(tmpdir(), 'botgarten-order-'))
afterAll(() => rmSync(out, { recursive: true }))

describe('botgarten print refuses before a browser starts, and says in words', () => {
  it.each([
    [['q-cty'], /^botgarten: There is no item "q-cty"\. Did you mean q-city,/],
    [[], /^botgarten: /],
    [['all', '--address', 'nowhere'], /--address takes an address such as/],
    [['pack', 'lesson-33'], /There is no pack "lesson-33"\. Did you mean lesson-3/],
    [['pack', 'lesson-3', '--pupils', 'many'], /--pupils takes a number/],
    [['pack', 'lesson-3', '--sets', '21'], /--sets takes a number/],
    [['pack', 'lesson-3', '--lang', 'en,xx'], /--lang takes de or en, not "xx"/],
  ])('%j', async (args, said) => {
    const answer = await botgarten('print', ...args, '--out', out)
    expect(answer).toMatchObject({ status: 2, stdout: '', stderr: expect.stringMatching(said) as string })
    expect(readdirSync(out)).toEqual([])
  })

  it('a folder that cannot be made', async () => {
    const file = join(out, 'file')
    writeFileSync(file, '')
    const unwritable = await botgarten('print', 'q-city', '--out', join(file, 'below'))
    expect(unwritable).toMatchObject({ status: 1, stdout: '' })
    expect(unwritable.stderr).toMatch(/^botgarten: The folder ".+below" cannot be made/)
    expect(readdirSync(out)).toEqual(['file'])
  })

  it('--help says every option', async () => {
    expect((await botgarten('print', '--help')).stdout).toContain('--turn short|long')
  })
})
