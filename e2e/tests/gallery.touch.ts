// Rooms: gallery, class
import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'

const test = testInClass('de')
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

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
  await child.button('gallery.remix').tap()
  await child.seesLab()
})
