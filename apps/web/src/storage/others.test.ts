import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { deleteDB } from 'idb'
import { freshDevice } from './testing/device.ts'
import { freshLocalStorage } from './testing/local.ts'
import { friendship } from './testing/sample.ts'

let texts: Map<string, string>
beforeEach(async () => {
  await freshDevice()
  texts = freshLocalStorage()
})
afterEach(async () => {
  vi.unstubAllGlobals()
  vi.resetModules()
  for (const pupil of ['p1', 'p2']) await deleteDB(`botgarten-${pupil}`)
})

/** An open page of the device for a pupil, or without a pupil if null. */
async function page(pupil: string | null) {
  const account = { pupil, class: 'c1', nickname: 'Eule', className: '5b' }
  if (pupil === null) texts.delete('botgarten.class')
  else texts.set('botgarten.class', JSON.stringify(account))
  vi.resetModules()
  const [projects, bin, database, others, own] = await Promise.all([
    import('./projects.ts'),
    import('./bin.ts'),
    import('./database.ts'),
    import('./others.ts'),
    import('./account.ts'),
  ])
  return { ...projects, ...bin, ...database, ...others, ...own }
}
const databases = async () => (await indexedDB.databases()).map(({ name }) => name).sort()

describe('the work of a pupil', () => {
  test('is saved apart from that of the device and of other pupils', async () => {
    const device = await page(null)
    await device.save('one', friendship, 0)
    const pupil = await page('p1')
    expect([pupil.account()!.pupil, pupil.ownName('x'), (await pupil.list()).projects]).toEqual([
      'p1',
      'x-p1',
      [],
    ])
    await pupil.save('two', friendship, 0)
    expect((await device.list()).projects.map(({ id }) => id)).toEqual(['one'])
  })

  test('is known to be there by others, who cannot read it', async () => {
    const pupil = await page('p1')
    expect(await pupil.holdsWorkOfOthers()).toBe(false)
    await pupil.save('two', friendship, 0)
    expect(await pupil.holdsWorkOfOthers()).toBe(false)
    expect(await (await page(null)).holdsWorkOfOthers()).toBe(true)
    expect(await (await page('p2')).holdsWorkOfOthers()).toBe(true)
  })

  test('that of the device itself is that of others for a pupil; an empty one is no work', async () => {
    const device = await page(null)
    await device.save('one', friendship, 0)
    const pupil = await page('p1')
    expect(await pupil.holdsWorkOfOthers()).toBe(true)
    await device.throwAway('one')
    expect(await pupil.holdsWorkOfOthers()).toBe(false)
  })
})

describe('what a class has', () => {
  test('is deleted with its database where the bin is empty', async () => {
    const pupil = await page('p1')
    await pupil.save('two', friendship, 0)
    expect(await databases()).toContain('botgarten-p1')
    await pupil.deleteSent()
    expect(await databases()).not.toContain('botgarten-p1')
  })

  test('is deleted, and the bin waits for the pupil to come back', async () => {
    const pupil = await page('p1')
    await pupil.save('two', friendship, 0)
    await pupil.save('three', friendship, 0)
    await pupil.throwAway('two')
    await pupil.deleteSent()
    expect((await pupil.list()).projects).toEqual([])
    expect((await pupil.listBin()).thrown).toHaveLength(1)
    await pupil.deleteOwnDatabase()
    expect(await databases()).not.toContain('botgarten-p1')
  })

  test('is never that of the device itself', async () => {
    const device = await page(null)
    await device.save('one', friendship, 0)
    await device.deleteOwnDatabase()
    expect((await device.list()).projects.map(({ id }) => id)).toEqual(['one'])
  })
})
