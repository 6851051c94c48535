import { address, announcedElsewhere } from '#features/address/feature.ts'
import { schoolClass } from '#features/class/feature.ts'
import { loadPart } from '#parts/feature.ts'
import { account } from '#storage/account.ts'

/** Who sits here, where it is a pupil. */
const pupil = async () => (account() ? (await loadPart(schoolClass)).memberHere() : null)

/** Saves all that this device keeps for who sits here. */
async function takeHome(): Promise<void> {
  const { homeFiles } = await import('#storage/files.ts')
  for (const file of await homeFiles()) file.save()
}

/** What leads to the announced address; null where the page is under it already. */
export async function leadingAway() {
  const announced = await announcedElsewhere(location)
  if (announced === null) return null
  const [{ Elsewhere, keptHere }, member] = await Promise.all([loadPart(address), pupil()])
  return {
    ...{ Elsewhere, announced, kept: await keptHere(), onhome: takeHome },
    waiting: () => member?.waiting ?? null,
    onsend: async () => (await member?.outbox.flush()) === null && member?.waiting === 0,
  }
}
