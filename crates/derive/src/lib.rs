//! `#[derive(State)]` of [forage-lab](https://docs.rs/forage-lab): what a planner's state adds to the hash of its run, and how
//! much memory it takes, both from the same list of fields. A field that is added later is in both.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Attribute, Data, DeriveInput, Error, Field, Fields, Generics, Ident, parse_macro_input, parse_quote};

/// Implements `forage::kernel::State`.
///
/// Every field is part of the hash and of the size, and so must implement `State` itself, unless it is marked:
/// - `#[state(skip)]`: counted but not hashed. For scratch memory and caches, which no result depends on.
/// - `#[state(shared)]`: neither. For what follows from the setup, such as the scene, or from the other fields.
#[proc_macro_derive(State, attributes(state))]
pub fn derive_state(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    state(input).unwrap_or_else(Error::into_compile_error).into()
}

fn state(input: DeriveInput) -> Result<TokenStream, Error> {
    let DeriveInput { ident, generics, data, attrs, .. } = input;
    unmarked(&attrs)?;
    let [digest, size] = match &data {
        Data::Struct(data) => {
            let parts = Parts::of(&data.fields)?;
            let (pattern, digest, size) = (parts.pattern(), parts.digest(), parts.size());
            [quote! { let Self #pattern = self; #digest }, quote! { let Self #pattern = self; #size }]
        }
        Data::Enum(data) => {
            let mut arms = [Vec::new(), Vec::new()];
            for (number, variant) in data.variants.iter().enumerate() {
                unmarked(&variant.attrs)?;
                let parts = Parts::of(&variant.fields)?;
                let (name, number) = (&variant.ident, number as u64);
                let (pattern, digest, size) = (parts.pattern(), parts.digest(), parts.size());
                arms[0].push(quote! { Self::#name #pattern => { out.word(#number); #digest } });
                arms[1].push(quote! { Self::#name #pattern => { #size } });
            }
            arms.map(|arms| quote! { match self { #(#arms)* } })
        }
        Data::Union(_) => return Err(Error::new_spanned(ident, "a union's state is not known; use an enum")),
    };
    let bounded = with_bounds(generics);
    let (implementation, arguments, conditions) = bounded.split_for_impl();
    Ok(quote! {
        #[automatically_derived]
        impl #implementation ::forage::kernel::State for #ident #arguments #conditions {
            #[allow(unused_variables)]
            fn digest(&self, out: &mut ::forage::kernel::Digest) { #digest }
            fn heap_size(&self) -> usize { #size }
        }
    })
}

/// Type parameters must have a state, too.
fn with_bounds(mut generics: Generics) -> Generics {
    for parameter in generics.type_params_mut() {
        parameter.bounds.push(parse_quote!(::forage::kernel::State));
    }
    generics
}

/// What becomes of a field.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Whole,
    Skipped,
    Shared,
}

/// The fields of a struct or of a variant: how each is called in a pattern, and what becomes of it.
struct Parts {
    named: bool,
    fields: Vec<(Option<Ident>, Ident, Part)>,
}

impl Parts {
    fn of(fields: &Fields) -> Result<Self, Error> {
        let named = matches!(fields, Fields::Named(_));
        let one = |(i, field): (usize, &Field)| Ok((field.ident.clone(), format_ident!("field_{i}"), part(&field.attrs)?));
        Ok(Self { named, fields: fields.iter().enumerate().map(one).collect::<Result<_, Error>>()? })
    }

    fn pattern(&self) -> TokenStream {
        let one = |(name, binding, part): &(Option<Ident>, Ident, Part)| {
            let binding = if *part == Part::Shared { quote!(_) } else { quote!(#binding) };
            name.as_ref().map_or(binding.clone(), |name| quote!(#name: #binding))
        };
        let fields: Vec<_> = self.fields.iter().map(one).collect();
        match (self.named, fields.is_empty()) {
            (true, _) => quote!({ #(#fields),* }),
            (false, true) => quote!(),
            (false, false) => quote!((#(#fields),*)),
        }
    }

    fn digest(&self) -> TokenStream {
        let fields = self.fields.iter().filter(|(.., part)| *part == Part::Whole).map(|(_, binding, _)| binding);
        let skipped = self.fields.iter().filter(|(.., part)| *part == Part::Skipped).map(|(_, binding, _)| binding);
        quote! { #(let _ = #skipped;)* #(::forage::kernel::State::digest(#fields, out);)* }
    }

    fn size(&self) -> TokenStream {
        let fields = self.fields.iter().filter(|(.., part)| *part != Part::Shared).map(|(_, binding, _)| binding);
        quote! { 0 #(+ ::forage::kernel::State::heap_size(#fields))* }
    }
}

/// Refuses a mark where there is no field.
fn unmarked(attributes: &[Attribute]) -> Result<(), Error> {
    match attributes.iter().find(|attribute| attribute.path().is_ident("state")) {
        Some(attribute) => Err(Error::new_spanned(attribute, "only a field has a mark")),
        None => Ok(()),
    }
}

fn part(attributes: &[Attribute]) -> Result<Part, Error> {
    let mut part = Part::Whole;
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("state")) {
        attribute.parse_nested_meta(|meta| {
            if part != Part::Whole {
                return Err(meta.error("a field has one mark: `skip` or `shared`"));
            }
            part = match () {
                () if meta.path.is_ident("skip") => Part::Skipped,
                () if meta.path.is_ident("shared") => Part::Shared,
                () => return Err(meta.error("there are `skip` (counted, not hashed) and `shared` (neither)")),
            };
            Ok(())
        })?;
    }
    Ok(part)
}
