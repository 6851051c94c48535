// Rooms: class, storage
import { isLong } from '@botgarten/numbers/testing'
import { Child, leftEye, leftWheel } from '../child.ts'
import { Pupil } from '../child-class.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn, type Joined } from '../made-class.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// A request through a pulled cable fails, and a browser complains of it.
test.use({ complaints: [/net::ERR_/] })

const seconds = isLong ? 600 : 10
const names = ['Ananas', 'Biber', 'Dachs', 'Eule', 'Falke']

interface Saved {
  readonly revision: number
  readonly project: { readonly brains: { readonly [id: string]: { readonly weights: object } } }
}

/** The weight of the knob that a child has turned, in a project of the class. */
const weightIn = ({ project }: Saved) =>
  Math.max(
    ...[...JSON.stringify(project.brains).matchAll(/:(-?[\d.]+)/g)].map(([, digits]) => Number(digits)),
  )

/** All versions of a pupil's card in the class, the newest first. */
async function versionsOf({ asker }: Joined): Promise<readonly number[]> {
  const path = '/projects/project-friendship'
  const { versions } = (await asker.ask('GET', `${path}/versions`)).body as { versions: readonly Saved[] }
  const all = versions.map(({ revision }) => asker.ask('GET', `${path}/versions/${revision}`))
  return (await Promise.all(all)).map(({ body }) => weightIn(body as Saved))
}

test('the cable of a class is pulled again and again while five children work: nothing is lost, nothing doubled', async ({
  browser,
  school,
  contextOptions,
  house,
}) => {
  test.setTimeout((seconds + 120) * 1000)
  const children = await Promise.all(
    names.map(async (nickname) => {
      const context = await browser.newContext({ ...contextOptions, baseURL: house, locale: 'en-GB' })
      const child = new Child(await context.newPage(), 'en')
      const pupil = await joins(school, nickname)
      await signsIn(child.page, school, pupil)
      await child.opensLab('friendship')
      return { context, child, pupil }
    }),
  )
  const end = Date.now() + seconds * 1000
  let rounds = 0
  const work = () => (1 + (rounds % 90)) / 100
  while (Date.now() < end) {
    rounds += 1
    // A different half of the class is cut off each time.
    for (const [at, { context }] of children.entries()) await context.setOffline((at + rounds) % 2 === 0)
    for (const { child } of children) await child.typesWeight(leftEye, leftWheel, work())
  }
  for (const { context } of children) await context.setOffline(false)
  for (const { child, pupil, context } of children) {
    await expect(new Pupil(child, school).chip('chipClass')).toBeVisible({ timeout: 90_000 })
    const versions = await versionsOf(pupil)
    expect(versions[0]).toBe(work())
    expect(new Set(versions).size).toBe(versions.length)
    await context.close()
  }
})
