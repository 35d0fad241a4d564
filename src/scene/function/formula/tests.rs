use super::*;
use crate::scene::Function;

fn value(text: &str, x: &[f64]) -> f64 {
    Formula::new(text, x.len()).unwrap_or_else(|error| panic!("{text}: {error}")).value(x, &mut Vec::new())
}

fn refused(text: &str, dimension: usize) -> String {
    match Formula::new(text, dimension) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("{text} is accepted"),
    }
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, expected) in [
        ("1 + 2 * 3", 7.0),
        ("2 - 3 - 4", -5.0),
        ("2 ^ 3 ^ 2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2**3", 8.0),
        ("-(2 + 1) * 4 / 3", -4.0),
        ("7 % 4 + -7 % 4", 4.0),
        ("1 < 2 && 2 >= 3 || !0", 1.0),
        ("2 == 2 ? 5 : 6", 5.0),
        ("0 ? 1 : 0 ? 2 : 3", 3.0),
        ("if(1 > 2, 1, 2)", 2.0),
        ("min(3, 1, 2) + max(4, 5)", 6.0),
        ("1.5e1 + .5 + 2.", 17.5),
        ("- -1", 1.0),
        ("2 * pi - tau", 0.0),
        ("sqrt(16) + abs(-1) + sign(-3) + floor(1.5) + mod(-1, 3)", 7.0),
    ] {
        assert_eq!(value(text, &[0.0]), expected, "{text}");
    }
}

#[test]
fn variables_sums_and_products_are_of_the_position() {
    let x = [2.0, 3.0, -1.0];
    for (text, expected) in [
        ("x + 10 * y + 100 * z", -68.0),
        ("x[1] + x[n]", 1.0),
        ("sum(x[i])", 4.0),
        ("prod(x[i])", -6.0),
        ("sum(i * x[i])", 5.0),
        ("sum(x[k]^2, k)", 14.0),
        ("sum(x[i+1] - x[i], i, 1, n - 1)", -3.0),
        ("sum(x[n + 1 - i] * i)", 11.0),
        ("sum(sum(x[i] * x[j], j, 1, i), i, 1, n)", 4.0 + 15.0 - 4.0),
        ("sum(prod(x[j], j, 1, i))", 2.0 + 6.0 - 6.0),
        ("sum(x[i], i, 2, 1) + prod(x[i], i, 2, 1)", 1.0),
        ("sum(2)", 6.0),
        ("sum(x[i] > 0 ? x[i] : 0)", 5.0),
        ("sum(x[2*i - 1], i, 1, 2)", 1.0),
    ] {
        assert_eq!(value(text, &x), expected, "{text}");
    }
}

#[test]
fn test_functions_by_formula_agree_with_those_built_in() {
    let x = [0.3, -1.7, 2.5, 0.01];
    for (function, text) in [
        (Function::Sphere, "sum(x[i]^2)"),
        (Function::Rosenbrock, "sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)"),
        (Function::Rastrigin, "sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)"),
        (Function::Ackley, "-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e"),
    ] {
        let (ours, built_in) = (value(text, &x), function.value(&x));
        assert!((ours - built_in).abs() < 1e-13 * built_in.abs(), "{}: {ours} is not {built_in}", function.name());
    }
    let x = [1.25, -0.75];
    assert_eq!(value("0.26*(x^2 + y^2) - 0.48*x*y", &x), Function::Matyas.value(&x));
    assert_eq!(value("x^2 + y^2 + 25*(sin(x)^2 + sin(y)^2)", &x), Function::EggCrate.value(&x));
}

#[test]
fn errors_name_the_place_and_what_is_expected_there() {
    for (text, dimension, expected) in [
        ("", 2, "character 1: the formula ends here; expected: a number, a name or ("),
        ("1 +", 2, "character 4: the formula ends here"),
        ("1 + * 2", 2, "character 5: `*` can’t stand here; expected: a number, a name or ("),
        ("(1 + 2", 2, "character 7: the formula ends here; expected: )"),
        ("2 x", 2, "character 3: `x` can’t stand here; expected: an operator, or the end"),
        ("αx", 2, "character 1: `α` can’t stand here"),
        ("x + foo", 2, "character 5: there is no `foo`; known: x[i], x, y, z, n, pi, tau, e"),
        ("sum(x[i] + q)", 2, "known: x[i], x, y, z, n, pi, tau, e, i"),
        ("x + foo(2)", 2, "character 5: there is no function `foo`; known: sum, prod"),
        ("sin", 2, "`sin` is a function: it needs brackets"),
        ("sin(1, 2)", 2, "sin(…) is given one number"),
        ("atan2(1)", 2, "atan2(…) is given two numbers"),
        ("z", 2, "`z` is variable 3, and there are 2"),
        ("x[3]", 2, "x[3] is none of x[1] to x[2]"),
        ("sum(x[i+1])", 2, "x[3] is none of x[1] to x[2]"),
        ("x[0.5]", 2, "an index is a whole number"),
        ("x[x]", 2, "an index is a whole number"),
        ("y[1]", 2, "only x has an index"),
        ("sum(1, n, 1, 2)", 2, "`n` means something else"),
        ("sum(1, 2)", 2, "sum(…) is given a body"),
        ("1e999", 2, "`1e999` is no finite number"),
        ("sum(sum(sum(1, i, 1, 1000), j, 1, 1000), k, 1, 1000)", 2, "more than 300000 operations"),
    ] {
        let error = refused(text, dimension);
        assert!(error.contains(expected), "{text}: {error}");
    }
    assert!(refused(&"(".repeat(3000), 1).contains("40 deep"));
    assert!(refused(&format!("1{}", " + 1".repeat(2000)), 1).contains("at most 4096 bytes"));
    assert!(Formula::new(&"-".repeat(4000), 1).is_err() && Formula::new(&format!("1{}", "^1".repeat(2000)), 1).is_ok());
}

#[test]
fn outside_of_where_it_is_defined_a_value_is_not_finite() {
    assert!(value("ln(x)", &[-1.0]).is_nan() && value("1/x", &[0.0]).is_infinite());
    assert!(value("sum(0*ln(x[i]))", &[-1.0, 1.0]).is_nan());
    assert_eq!(value("x > 0 ? ln(x) : 0", &[-1.0]), 0.0);
}
