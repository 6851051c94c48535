// One answer a pupil and form, without saying whose it is: VOPRF of RFC 9497 (ristretto255-SHA512). The class evaluates one
// blinded input a pupil. Blinding hides the input completely (no computing power helps), so that the class cannot match an
// answer with a pupil. Nothing here needs crypto.subtle, which pages on plain http do not have. All values are hexadecimal.
import { ristretto255_oprf } from '@noble/curves/ed25519.js'
import { bytesToHex, hexToBytes } from '@noble/curves/utils.js'

const { oprf, voprf } = ristretto255_oprf

/** That many random bytes, good enough for secrets. */
type Random = (bytes: number) => Uint8Array

/** Of one form of one class. */
export interface FormKey {
  /** 32 bytes: makes tokens. */
  readonly secretKey: string
  /** 32 bytes: the same for all pupils of the class. */
  readonly publicKey: string
}

/** Stored on a device until its pupil has answered. */
export interface BlindedInput {
  /** 32 random bytes. */
  readonly input: string
  /** 32 bytes, secret: they match the blinded input with the token. */
  readonly blind: string
  /** 32 bytes: the class sees only these. */
  readonly blinded: string
}

/** The answer of the class to a blinded input. */
export interface Evaluation {
  /** 32 bytes. */
  readonly evaluated: string
  /** 64 bytes: the secret key of the public key was used. */
  readonly proof: string
}

/** Allows one answer. */
export interface Token {
  /** 32 random bytes. */
  readonly input: string
  /** 64 bytes: only the secret key makes them of the input. */
  readonly output: string
}

const info = new TextEncoder().encode('botgarten questionnaire')
const rng = (random: Random) => (bytes?: number) => random(bytes ?? 32)
const secureRandom: Random = (bytes) => crypto.getRandomValues(new Uint8Array(bytes))

export function newFormKey(random: Random): FormKey {
  const { secretKey, publicKey } = voprf.deriveKeyPair(random(32), info)
  return { secretKey: bytesToHex(secretKey), publicKey: bytesToHex(publicKey) }
}

/** Blinds an input. @param input any bytes; by chance if it is left out */
export function blindInput(
  random: Random = secureRandom,
  input: string = bytesToHex(random(32)),
): BlindedInput {
  const { blind, blinded } = voprf.blind(hexToBytes(input), rng(random))
  return { input, blind: bytesToHex(blind), blinded: bytesToHex(blinded) }
}

/** Evaluates a blinded input. @throws if it is no element of the group */
export function evaluateBlinded(
  { secretKey, publicKey }: FormKey,
  blinded: string,
  random: Random,
): Evaluation {
  const [secret, open] = [hexToBytes(secretKey), hexToBytes(publicKey)]
  const { evaluated, proof } = voprf.blindEvaluate(secret, open, hexToBytes(blinded), rng(random))
  return { evaluated: bytesToHex(evaluated), proof: bytesToHex(proof) }
}

/** Makes the token of an evaluation. @throws if it was not made with the secret key of this public key */
export function tokenOf(
  { input, blind, blinded }: BlindedInput,
  { evaluated, proof }: Evaluation,
  publicKey: string,
): Token {
  const [bytes, secret, ours] = [hexToBytes(input), hexToBytes(blind), hexToBytes(blinded)]
  const output = voprf.finalize(
    ...([bytes, secret, hexToBytes(evaluated), ours, hexToBytes(publicKey)] as const),
    hexToBytes(proof),
  )
  return { input, output: bytesToHex(output) }
}

/** The output that belongs to an input. Blinding is only a detour to it: the library's types have no direct way. */
export function outputOf({ secretKey }: FormKey, input: string): string {
  const bytes = hexToBytes(input)
  const { blind, blinded } = voprf.blind(bytes)
  const evaluated = oprf.blindEvaluate(hexToBytes(secretKey), blinded)
  return bytesToHex(oprf.finalize(bytes, blind, evaluated))
}

/** The id of the one answer that a token allows: a keyed hash of the input, so that a token that is spent twice is one answer. */
export const answerIdOf = ({ output }: Token): string => output.slice(0, 32)
