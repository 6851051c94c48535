// Rooms: class, storage, share, sorting
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { SortingHands } from '../child-sorting.ts'
import { Child, leftEye, leftWheel, rightEye, rightWheel } from '../child.ts'
import { Asker } from '../class-server.ts'
import { earlierVersions, linksOf, profileOf, putProfile, serverOfEarlier } from '../earlier-device.ts'
import { expect, test as base } from '../house.ts'

type Server = Awaited<ReturnType<typeof serverOfEarlier>>

for (const version of earlierVersions) {
  const test = base.extend<object, { server: Server }>({
    server: [
      // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures
      async ({}, use) => {
        const server = await serverOfEarlier(version)
        await use(server)
        await server.close()
      },
      { scope: 'worker' },
    ],
    house: [({ server }, use) => use(server.url), { scope: 'worker' }],
  })
  // Work must not be lost: a fault here gets no further try.
  test.describe.configure({ retries: 0 })
  // A browser reports the 401 after which the page requests the pictures.
  test.use({ complaints: [/401 \(Unauthorized\)/] })

  /** The revision of a pupil's project that the class has. */
  async function revisionOf({ classServer }: Server, card: string): Promise<number> {
    const { revision } = await classServer.ports.database.db
      .selectFrom('project')
      .select('revision')
      .where('card', '=', card)
      .executeTakeFirstOrThrow()
    return revision
  }

  test(`a device of ${version} has its projects, settings and class, and sends the change that was not sent`, async ({
    page,
    server,
  }) => {
    const profile = profileOf(version)
    await expect.poll(() => revisionOf(server, 'fear')).toBe(1)
    await putProfile(page, server.url, profile)
    const child = new Child(page, 'en')
    const pupil = new Pupil(child, { code: '' })
    await page.goto('/')
    await child.presses('class.yesOn')
    await pupil.taps(...profile.pictures)
    await child.presses('class.toGarden')
    await pupil.seesMe()
    await expect.poll(() => revisionOf(server, 'fear')).toBe(2)

    const list = new ProjectList(child)
    await list.opens()
    await expect
      .poll(async () => (await list.names()).toSorted())
      .toEqual([child.card('fear'), child.card('friendship'), child.word('home.sortingTitle')].toSorted())
    await seesSorting(child)
    await child.opensLab('fear')
    await child.seesWeight(leftEye, rightWheel, 0.6)
    await child.seesWeight(rightEye, leftWheel, 0.7)
    await expect(child.button('lab.soundOn').first()).toBeVisible()
    await expect(pupil.chip('chipClass')).toBeVisible()
    await child.opensLab('friendship')
    await child.seesWeight(leftEye, leftWheel, 0.8)

    // The work from before the class belongs to the device, which shows it once the pupil has left.
    await pupil.leaves()
    await child.opensLab('friendship')
    await child.seesWeight(leftEye, leftWheel, 0.45)
    await seesSorting(child)
  })

  /** The sorting, which was a setting, as a project: seven points by hand, groups of objects, readings. */
  async function seesSorting(child: Child) {
    const sorting = new SortingHands(child)
    await sorting.opens('points')
    await sorting.seesPoints(7)
    await expect(sorting.group(2)).toHaveValue('Mine')
    await sorting.presses('tab.things')
    await expect(sorting.group(1)).toHaveValue('Bottles')
    await sorting.presses('tab.readings')
    await expect(sorting.words('noReadings')).toHaveCount(0)
  }

  test.describe('links', () => {
    const links = linksOf(version)
    /** Waits for the page that a link of this kind leads to. */
    const leadsTo: { readonly [kind: string]: (child: Child) => Promise<unknown> } = {
      project: async (child) => {
        await child.seesLab()
        await child.seesWeight(leftEye, leftWheel, 0.45)
      },
      join: ({ page }) => expect(page.locator('#nickname')).toBeVisible(),
      invitation: (child) => expect(child.button('teacher.makeAccount')).toBeVisible(),
      substitute: ({ page }) => expect(page.getByText('5b').first()).toBeVisible(),
      projector: (child) =>
        expect(child.page.getByRole('img', { name: child.word('teacher.qr') })).toBeVisible(),
      teacher: (child) => expect(child.words('teacher.kept')).toBeVisible(),
      cage: (child) => expect(child.button('zoo.learn')).toBeVisible(),
      sheet: (child) => expect(child.page.getByText(child.card('friendship')).first()).toBeVisible(),
    }
    const asTeacher = ['projector', 'teacher']

    test(`every kind of link of ${version} is tested`, () => {
      expect(Object.keys(links).toSorted()).toEqual(Object.keys(leadsTo).toSorted())
    })

    for (const [kind, link] of Object.entries(links))
      test(`a link of ${version} to this opens: ${kind}`, async ({ page, server }) => {
        if (asTeacher.includes(kind)) {
          const teacher = new Asker(server.url)
          const credentials = { username: 'm.weber', password: 'kastanie im regen' }
          await teacher.ask('POST', '/auth/sign-in/username', credentials)
          await page.context().addCookies(teacher.cookies)
        }
        // By address: these are links.
        await page.goto(link)
        await leadsTo[kind]!(new Child(page, 'en'))
      })
  })
}
