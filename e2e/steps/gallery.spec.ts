import { GalleryHands, sharesOne } from '../child-gallery.ts'
import type { Child } from '../child.ts'
import { goesHome } from '../navigation.ts'
import { joins, saves, signsIn } from '../made-class.ts'
import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const press = (key: string) => (child: Child) => child.presses(key)

test('what a class shares, step by step', { tag: '@gallery' }, async ({ child, page, school }) => {
  const gallery = new GalleryHands(child)
  const dialog = page.getByRole('dialog')
  const reachesClass = () => expect(child.button('class.chipClass')).toBeVisible()
  const chooses = () => dialog.getByRole('radio').first().check({ force: true })
  const [fox, owl] = [await joins(school, 'Fuchs'), await joins(school, 'Eule')]
  await saves(fox, { program: 'start', starts: [] })
  await signsIn(page, school, fox)
  await goesThrough(
    child,
    'gallery',
    {
      'a gallery with nothing': async () => {
        await child.opensLab('friendship')
        await gallery.opens()
      },
      'nothing of mine': press('gallery.mine'),
      'one of mine is to be shared': press('gallery.shareOne'),
      'it is not shared': press('parts.close'),
      'it is to be shared again': press('gallery.shareOne'),
      'it is chosen': chooses,
      'it has a title': () => dialog.getByLabel(child.word('gallery.title')).fill('My maze'),
      'it is shared': async () => {
        await dialog.getByRole('button', { name: child.word('gallery.share'), exact: true }).click()
        await expect(child.words('gallery.shared')).toBeVisible()
      },
      'that is known': press('parts.ok'),
      'all of the class': async () => {
        const id = await sharesOne(owl, 'Slow and safe')
        await sharesOne(owl, 'Faster', { more: { madeFrom: [{ id, title: 'Slow and safe' }] } })
        await child.presses('gallery.mostHearts')
        await expect(gallery.titles).toHaveCount(3)
      },
      'a heart': () => gallery.heart('Slow and safe', 0).click(),
      'no heart': () => gallery.heart('Slow and safe', 1).click(),
      'the newest first': press('gallery.newest'),
      'one is looked at': async () => {
        await gallery.looks('Faster')
        await expect(child.button('gallery.watch')).not.toHaveAttribute('aria-disabled')
      },
      'a heart for it': () => gallery.heart('Faster', 0).last().click(),
      'it drives fast, and goes back': async () => {
        const start = await gallery.place()
        await gallery.looked.getByLabel(child.word('gallery.speed')).selectOption('16')
        await child.presses('gallery.watch')
        await expect(child.button('gallery.pause')).toBeVisible()
        await expect.poll(gallery.place).not.toEqual(start)
        await child.presses('gallery.pause')
        await expect(child.button('gallery.watch')).toBeVisible()
        await child.presses('gallery.toStart')
        await expect.poll(gallery.place).toEqual(start)
      },
      'a ghost drives along': async () => {
        await gallery.looked.getByLabel(child.word('gallery.ghost')).selectOption({ index: 1 })
        await expect(gallery.looked.locator('svg g.ghost')).toBeVisible()
      },
      'its file is saved and its brain is wanted': async () => {
        await Promise.all([page.waitForEvent('download'), child.presses('gallery.file')])
        await child.presses('gallery.takeBrain')
        await expect(dialog.getByRole('radio').first()).toBeAttached()
      },
      'a project for the brain': chooses,
      'no brain': () => dialog.getByRole('button', { name: child.word('parts.close') }).click(),
      'it is to drive beside mine': async () => {
        await child.presses('gallery.beside')
        await expect(dialog.getByRole('radio').first()).toBeAttached()
        await chooses()
      },
      'it drives beside mine': async () => {
        await dialog.getByRole('button', { name: child.word('gallery.drive') }).click()
        await reachesClass()
      },
      'the brain is in mine': async () => {
        await gallery.opens()
        await gallery.looks('Faster')
        await child.presses('gallery.takeBrain')
        await dialog.getByText('Friendship', { exact: true }).click()
        await dialog.getByRole('button', { name: child.word('gallery.takeBrain') }).click()
        await reachesClass()
      },
      'mine is looked at': async () => {
        await gallery.opens()
        await gallery.looks('My maze')
        await expect(child.button('gallery.watch')).not.toHaveAttribute('aria-disabled')
      },
      'on a narrow screen': () => page.setViewportSize({ width: 700, height: 900 }),
      'it is closed': () => gallery.looked.getByRole('button', { name: child.word('parts.close') }).click(),
      'mine is taken out': async () => {
        await gallery.looks('My maze')
        await child.presses('gallery.takeOut')
        await expect(gallery.titles).toHaveCount(2)
      },
      'a remix': async () => {
        await gallery.looks('Slow and safe')
        await child.presses('gallery.remix')
        await reachesClass()
      },
      'the race of four brains': async () => {
        await page.setViewportSize({ width: 1366, height: 768 })
        await gallery.opens()
        await gallery.looks('Slow and safe')
        await child.presses('gallery.fourBrains')
        await expect(page).toHaveURL(/brains=garden/)
        await goesHome(child)
      },
    },
    { hides: /(?<=p=)friendship-\w+|(?<=[ "])(now|\d+ minutes? ago)\b/g },
  )
})
