import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { leftEye, leftWheel } from '../child.ts'
import { joins, signsIn } from '../made-class.ts'
import { expect, link, test } from './gate.ts'

test.use({ language: 'en' })

test(
  'what a classmate shares is liked, watched and remixed; the remix is shared with where it comes from',
  {
    tag: ['@gallery', '@/gallery'],
  },
  async ({ child, page, school }) => {
    const fox = await joins(school, 'Fuchs')
    const [owl, hare] = [await joins(school, 'Eule'), await joins(school, 'Hase')]
    const id = await sharesOne(owl, 'Slow and safe')
    await signsIn(page, school, fox)
    const gallery = new GalleryHands(child)
    await child.opensHome()
    await link(child, 'class.gallery').click()
    await expect(gallery.titles).toHaveText(['Slow and safe'])
    await gallery.heart('Slow and safe', 0).click()
    await expect(gallery.heart('Slow and safe', 1)).toHaveAttribute('aria-pressed', 'true')

    await gallery.looks('Slow and safe')
    const start = await gallery.place()
    await child.presses('gallery.watch')
    await expect.poll(gallery.place).not.toEqual(start)
    // Another pupil's heart does not stop the drive.
    await hare.asker.ask('PUT', `/gallery/${id}/heart`, { on: true })
    await expect(gallery.heart('Slow and safe', 2).first()).toBeVisible()
    await expect(child.button('gallery.pause')).toBeVisible()
    await child.presses('gallery.toStart')
    await expect.poll(gallery.place).toEqual(start)

    await child.presses('gallery.remix')
    await child.seesLab()
    await child.seesWeight(leftEye, leftWheel, 0.8)
    await child.typesWeight(leftEye, leftWheel, 0.5)
    await child.presses('lab.menu')
    await child.presses('parts.shareInClass')
    await page.getByRole('dialog').getByLabel(child.word('gallery.title')).fill('Faster')
    await page.keyboard.press('Enter')
    await expect(child.words('gallery.shared')).toBeVisible()
    const { body } = await owl.asker.ask('GET', '/gallery')
    const { items } = body as { items: { title: string; hearts: number }[] }
    expect(items.map(({ title }) => title)).toEqual(['Faster', 'Slow and safe'])
    await gallery.opens()
    await gallery.looks('Faster')
    await expect(gallery.looked.getByRole('listitem')).toContainText(['Slow and safe', 'Faster'])
  },
)
