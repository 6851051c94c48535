import fc from 'fast-check'
import { afterEach, expect, test, vi } from 'vitest'
import { answerIdOf, blindInput, evaluateBlinded, newFormKey, outputOf, tokenOf } from './tokens.ts'

// RFC 9497, Appendix A.1.2: ristretto255-SHA512, VOPRF mode, test vectors 1 and 2.
const key = {
  secretKey: 'e6f73f344b79b379f1a0dd37e07ff62e38d9f71345ce62ae3a9bc60b04ccd909',
  publicKey: 'c803e2cc6b05fc15064549b5920659ca4a77b2cca6f04f6b357009335476ad4e',
}
const blind = '64d37aed22a27f5191de1c1d69fadb899d8862b58eb4220029e036ec4c1f6706'
const proofScalar = '222a5e897cf59db8145db8d16e597e8facb80ae7d4e26d9881aa6f61d645fc0e'
const vectors = [
  {
    input: '00',
    blinded: '863f330cc1a1259ed5a5998a23acfd37fb4351a793a5b3c090b642ddc439b945',
    evaluated: 'aa8fa048764d5623868679402ff6108d2521884fa138cd7f9c7669a9a014267e',
    proof:
      'ddef93772692e535d1a53903db24367355cc2cc78de93b3be5a8ffcc6985dd06' +
      '6d4346421d17bf5117a2a1ff0fcb2a759f58a539dfbe857a40bce4cf49ec600d',
    output:
      'b58cfbe118e0cb94d79b5fd6a6dafb98764dff49c14e1770b566e42402da1a7d' +
      'a4d8527693914139caee5bd03903af43a491351d23b430948dd50cde10d32b3c',
  },
  {
    input: '5a5a5a5a5a5a5a5a5a5a5a5a5a5a5a5a5a',
    blinded: 'cc0b2a350101881d8a4cba4c80241d74fb7dcbfde4a61fde2f91443c2bf9ef0c',
    evaluated: '60a59a57208d48aca71e9e850d22674b611f752bed48b36f7a91b372bd7ad468',
    proof:
      '401a0da6264f8cf45bb2f5264bc31e109155600babb3cd4e5af7d181a2c9dc0a' +
      '67154fabf031fd936051dec80b0b6ae29c9503493dde7393b722eafdf5a50b02',
    output:
      '8a9a2f3c7f085b65933594309041fc1898d42d0858e59f90814ae90571a6df60' +
      '356f4610bf816f27afdd84f47719e480906d27ecd994985890e5f539e7ea74b6',
  },
] as const

/** Random bytes of which the library makes this scalar: it reads a number, little-endian, and adds 1 (never 0). */
const randomFor = (scalar: string) => (bytes: number) => {
  const number = BigInt(`0x${Buffer.from(scalar, 'hex').reverse().toString('hex')}`) - 1n
  return Uint8Array.from(Buffer.from(number.toString(16).padStart(2 * bytes, '0'), 'hex').reverse())
}
const random = (bytes: number) => crypto.getRandomValues(new Uint8Array(bytes))

afterEach(() => vi.unstubAllGlobals())

test.each(vectors)('blinding, evaluation, proof and output of $input are those of RFC 9497', (vector) => {
  const { input, blinded, evaluated, proof, output } = vector
  const made = blindInput(randomFor(blind), input)
  expect(made).toEqual({ input, blind, blinded })
  expect(evaluateBlinded(key, blinded, randomFor(proofScalar))).toEqual({ evaluated, proof })
  expect(tokenOf(made, { evaluated, proof }, key.publicKey)).toEqual({ input, output })
  expect(outputOf(key, input)).toBe(output)
  expect(answerIdOf({ input, output })).toBe(output.slice(0, 32))
})

test('the device and the class compute the same output, for every key', () => {
  fc.assert(
    fc.property(fc.uint8Array({ minLength: 32, maxLength: 32 }), (seed) => {
      const own = newFormKey(() => seed)
      const made = blindInput()
      const token = tokenOf(made, evaluateBlinded(own, made.blinded, random), own.publicKey)
      expect(token.output).toBe(outputOf(own, made.input))
      expect(made.input).toHaveLength(64)
    }),
    { numRuns: 10 },
  )
})

test('an evaluation with the key of another form, or for another device, makes no token', () => {
  const [ours, other] = [newFormKey(random), newFormKey(random)]
  const [made, more] = [blindInput(), blindInput()]
  const evaluation = evaluateBlinded(ours, made.blinded, random)
  expect(() => tokenOf(made, evaluateBlinded(other, made.blinded, random), ours.publicKey)).toThrow(/proof/)
  expect(() => tokenOf(made, evaluation, other.publicKey)).toThrow(/proof/)
  expect(() => tokenOf(more, evaluation, ours.publicKey)).toThrow(/proof/)
})

test('bytes that are no element of the group are not evaluated', () => {
  const identity = '0'.repeat(64)
  for (const blinded of [identity, 'f'.repeat(64), '00'])
    expect(() => evaluateBlinded(key, blinded, random)).toThrow()
})

test('the same input blinded twice shows the class two elements that have nothing in common', () => {
  const input = 'ab'.repeat(32)
  const [one, other] = [blindInput(random, input), blindInput(random, input)]
  expect(one.blinded).not.toBe(other.blinded)
  const finished = [one, other].map((made) =>
    tokenOf(made, evaluateBlinded(key, made.blinded, random), key.publicKey),
  )
  expect(finished[0]).toEqual(finished[1])
})

test('tokens are made where a page has no crypto.subtle, as on plain http', () => {
  const secure = crypto
  vi.stubGlobal('crypto', { getRandomValues: (bytes: Uint8Array) => secure.getRandomValues(bytes) })
  expect('subtle' in crypto).toBe(false)
  const made = blindInput()
  const { output } = tokenOf(made, evaluateBlinded(key, made.blinded, random), key.publicKey)
  expect(output).toBe(outputOf(key, made.input))
})
