// Rooms: app
import { readFileSync } from 'node:fs'
import { leftEye, leftWheel } from '../child.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

const built = new URL('../../apps/web/.svelte-kit/output/client/.vite/manifest.json', import.meta.url)
const manifest = JSON.parse(readFileSync(built, 'utf8')) as { readonly [source: string]: { file: string } }
const part = `**/${manifest['src/features/share/ShareDialog.svelte']!.file}`

for (const language of languagesOf(import.meta.filename))
  test.describe(`a part of the lab that does not come, in ${language}`, () => {
    // What the browser itself says about it: the cause stays in its console.
    test.use({ language, complaints: [/ERR_FAILED|Failed to fetch/] })

    test('is said, every press asks for it again, and once it is there the page loads again with all that was done', async ({
      child,
      page,
    }) => {
      await child.opensLab('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.4)
      await child.seesSaved()
      const note = page.getByRole('status').filter({ hasText: child.word('offline.partLost') })
      const close = note.getByRole('button', { name: child.word('parts.close') })
      await page.route(part, (route) => route.abort())
      const share = async () => {
        await child.presses('lab.menu')
        await child.presses('parts.share')
      }
      for (let press = 0; press < 2; press++) {
        await share()
        await close.click()
        await expect(note).toBeHidden()
      }

      await share()
      await page.route('**/lab/friendship*', (route) => route.abort())
      await child.presses('parts.again')
      await expect(note).toBeVisible()
      await child.seesWeight(leftEye, leftWheel, 0.4)

      await page.unrouteAll()
      await child.presses('parts.again')
      await expect(note).toBeHidden()
      await child.seesLab()
      await child.seesWeight(leftEye, leftWheel, 0.4)
      await share()
      await expect(page.getByRole('dialog')).toBeVisible()
    })
  })
