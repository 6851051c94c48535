import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { openClassServer } from './class-server.ts'

test('a server that starts again continues with the time for durations where it stopped', async () => {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-steady-'))
  const first = await openClassServer({ data })
  const began = first.ports.steady()
  await first.close()

  const second = await openClassServer({ data })
  expect(second.ports.steady()).toBeGreaterThanOrEqual(began)
  const rows = await second.ports.database.db.selectFrom('meta').selectAll().execute()
  const stopped = Number(rows.find(({ key }) => key === 'steady clock')!.value)
  expect(stopped).toBeGreaterThanOrEqual(began)
  // It was stopped in a time that the clock of the machine calls ten years later.
  const later = String(stopped + 10 * 365 * 86_400_000)
  await second.ports.database.db
    .updateTable('meta')
    .set({ value: later })
    .where('key', '=', 'steady clock')
    .execute()
  await second.close()

  const third = await openClassServer({ data })
  expect(third.ports.steady() - Number(later)).toBeLessThan(60_000)
  expect(third.ports.steady()).toBeGreaterThanOrEqual(Number(later))
  await third.close()
  rmSync(data, { recursive: true, force: true })
})
