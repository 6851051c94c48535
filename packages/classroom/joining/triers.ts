import { keyedHash } from '../hashes.ts'
import type { Pace, Trier } from './guesses.ts'

export interface Triers {
  /** The device's cookie; null for one that sends none, which is known by its address only. */
  readonly device: string | null
  /** An IPv6 address by its first 64 bits. */
  readonly address: string
}

/** Enough for a class behind one address in which every child mistypes the code twice. */
const ofAddress: Pace = { atOnce: 60, eachSecond: 0.2 }
const ofDevice: Pace = { atOnce: 20, eachSecond: 1 / 30 }
/** Each wrong one is one of the few that a nickname has. */
const ofPictures: Pace = { atOnce: 10, eachSecond: 1 / 30 }

const trier = (secret: Uint8Array, pace: Pace, ...parts: readonly string[]): Trier => ({
  key: keyedHash(secret, ...parts),
  pace,
})

/** The triers of a code. No address is held in the clear, not even in memory. */
export const triersOfCode = ({ device, address }: Triers, secret: Uint8Array): readonly Trier[] => [
  trier(secret, ofAddress, 'address', address),
  ...(device === null ? [] : [trier(secret, ofDevice, 'device', device)]),
]

/** The triers of pictures, whose nickname has a count of its own. */
export const triersOfPictures = ({ device, address }: Triers, secret: Uint8Array): readonly Trier[] => [
  trier(secret, ofAddress, 'address', address),
  ...(device === null ? [] : [{ ...trier(secret, ofPictures, 'device', device), waits: true }]),
]

const ofAccount: Pace = { atOnce: 10, eachSecond: 1 / 15 }
const ofSignIns: Pace = { atOnce: 30, eachSecond: 0.5 }

/** The triers of a password on an unknown device: the account slows them, the address gives way to others. */
export const triersOfAccount = (address: string, account: string, secret: Uint8Array): readonly Trier[] => [
  trier(secret, ofSignIns, 'address', address),
  { ...trier(secret, ofAccount, 'account', account), waits: true },
]

/** The trier of a password on a device that has signed in to the account before: tries of others do not count. */
export const triersOfKnown = (device: string, account: string, secret: Uint8Array): readonly Trier[] => [
  { ...trier(secret, ofAccount, 'known', device, account), waits: true },
]
