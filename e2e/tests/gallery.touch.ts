// Rooms: gallery, class
import { axeFindings } from '../axe.ts'
import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { classOfTest } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'

type School = Awaited<ReturnType<typeof classOfTest>>

const test = base.extend<object, { school: School }>({
  school: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const school = await classOfTest('de')
      await use(school)
      await school.close()
    },
    { scope: 'worker' },
  ],
  house: [({ school }, use) => use(school.url), { scope: 'worker' }],
})

test.use({ language: 'de' })

test('a finger gives a heart, watches and remixes', async ({ child, page, school }) => {
  const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
  await sharesOne(owl, 'Scheuer Bo')
  await signsIn(page, school, fox)
  const gallery = new GalleryHands(child)
  await gallery.opens()
  await gallery.heart('Scheuer Bo', 0).tap()
  await expect(gallery.heart('Scheuer Bo', 1)).toBeVisible()
  await gallery.looks('Scheuer Bo')
  const start = await gallery.place()
  await child.button('gallery.watch').tap()
  await expect.poll(gallery.place).not.toEqual(start)
  expect(await axeFindings(page)).toEqual([])
  await child.button('gallery.remix').tap()
  await child.seesLab()
})
